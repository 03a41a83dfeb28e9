// SPDX-License-Identifier: MIT
#include "host/files/bundled_files.hpp"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <vector>

#include "host/files/nearest_word.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::files {
namespace {

namespace fs = std::filesystem;

fs::path share_folder() {
  const char* chosen = std::getenv("ECHOMAP_SHARE");
  return chosen != nullptr && *chosen != '\0' ? chosen : ECHOMAP_SHARE_DIR;
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing)) {
    if (entry.path().extension() == ".toml") {
      names.push_back(entry.path().stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

fs::path bundled_file(const std::string& name_or_path,
                      const fs::path& folder,
                      const std::string& kind) {
  if (name_or_path.ends_with(".toml") || name_or_path.find('/') != std::string::npos) {
    return name_or_path;
  }
  const fs::path bundled = share_folder() / folder;
  fs::path path = bundled / (name_or_path + ".toml");
  if (!fs::exists(path)) {
    throw ConfigError("no " + kind + " is named '" + name_or_path + "' in " + bundled.string() +
                      suggestion(name_or_path, names_in(bundled)) +
                      "\n  next: name a bundled one, or a file that ends in .toml");
  }
  return path;
}

fs::path bundled_folder(const fs::path& folder) { return share_folder() / folder; }

std::vector<std::string> bundled_names(const fs::path& folder) {
  return names_in(share_folder() / folder);
}

}  // namespace echomap::files

// SPDX-License-Identifier: MIT
#include "tests/structure/source_tree.hpp"

#include <algorithm>
#include <fstream>
#include <regex>
#include <stdexcept>

namespace echomap::structure {

std::vector<std::string> read_lines(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) {
    throw std::runtime_error("cannot read " + file.string());
  }
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::vector<SourceFile> read_source_tree(const std::filesystem::path& root) {
  std::vector<SourceFile> files;
  for (const std::string& folder : source_folders) {
    if (!std::filesystem::exists(root / folder)) {
      continue;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (entry.is_regular_file() && (extension == ".cpp" || extension == ".hpp")) {
        const std::string path = entry.path().lexically_relative(root).generic_string();
        files.push_back({path, read_lines(entry.path())});
      }
    }
  }
  std::sort(files.begin(), files.end(), [](const SourceFile& left, const SourceFile& right) {
    return left.path < right.path;
  });
  return files;
}

std::vector<Include> includes_of(const SourceFile& file) {
  static const std::regex include_line(R"re(\s*#\s*include\s*(["<])([^">]+)[">].*)re");
  std::vector<Include> includes;
  int line_number = 0;
  for (const std::string& line : file.lines) {
    ++line_number;
    std::smatch match;
    const bool may_include = line.find('#') != std::string::npos;
    if (may_include && std::regex_match(line, match, include_line)) {
      includes.push_back({match[2].str(), line_number, match[1].str() == "\""});
    }
  }
  return includes;
}

bool is_below(const std::string& path, const std::string& folder) {
  return path == folder || path.rfind(folder + "/", 0) == 0;
}

bool is_header(const SourceFile& file) {
  return file.path.size() > 4 && file.path.compare(file.path.size() - 4, 4, ".hpp") == 0;
}

}  // namespace echomap::structure

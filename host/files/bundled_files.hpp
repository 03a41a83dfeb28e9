// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace echomap::files {

/// The TOML file that a user means: a path as it stands where `name_or_path` ends in .toml or has a
/// slash, otherwise NAME.toml in `folder` of the files that come with echomap (the source tree, or
/// where the environment's ECHOMAP_SHARE points). Throws ConfigError that names the nearest bundled
/// one; `kind` is the word for it: "world", "robot profile".
std::filesystem::path bundled_file(const std::string& name_or_path,
                                   const std::filesystem::path& folder,
                                   const std::string& kind);

/// A folder of the files that come with echomap.
std::filesystem::path bundled_folder(const std::filesystem::path& folder);

/// The names of the TOML files in such a folder, in alphabetical order.
std::vector<std::string> bundled_names(const std::filesystem::path& folder);

}  // namespace echomap::files

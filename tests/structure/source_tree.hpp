// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace echomap::structure {

/// One C++ source or header; `path` is relative to the root of its tree, with slashes.
struct SourceFile {
  std::string path;
  std::vector<std::string> lines;
};

/// One #include line; `line` counts from 1.
struct Include {
  std::string target;
  int line = 0;
  bool quoted = false;  ///< "target" rather than <target>.
};

/// The folders that hold sources.
inline const std::vector<std::string> source_folders{
    "protocol", "firmware", "host", "hil_mock", "tests"};

/// Reads every .cpp and .hpp below the source folders of `root`, sorted by path.
std::vector<SourceFile> read_source_tree(const std::filesystem::path& root);

/// The lines of a text file; throws std::runtime_error where it cannot be read.
std::vector<std::string> read_lines(const std::filesystem::path& file);

/// The includes of a file, whatever conditions they stand under.
std::vector<Include> includes_of(const SourceFile& file);

/// True when `path` is `folder` or lies below it.
bool is_below(const std::string& path, const std::string& folder);

/// True for a .hpp file.
bool is_header(const SourceFile& file);

}  // namespace echomap::structure

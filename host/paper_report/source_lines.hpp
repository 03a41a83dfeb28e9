// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace echomap::paper_report {

/// Finds the lines of source code that a report refers to.
class SourceLines {
 public:
  /// `root` is the root of the repository; it need not exist, as where only programs are installed.
  /// `link_base` is the address that links to source files begin with, such as
  /// "file:///home/me/echomap/"; empty: no links.
  explicit SourceLines(std::filesystem::path root, std::string link_base = {});

  /// Number of the first line of `file` that contains `symbol`, counted from 1; empty if no line
  /// does or the file cannot be read. `file` is a path from the root.
  std::optional<int> line(const std::string& file, const std::string& symbol) const;

  /// Address of a file; empty without a base.
  std::optional<std::string> link(const std::string& file) const;

 private:
  std::filesystem::path root_;
  std::string link_base_;
};

}  // namespace echomap::paper_report

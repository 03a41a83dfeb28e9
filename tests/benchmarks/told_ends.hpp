// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/markdown_table.hpp"
#include "tests/integration/staged_ends.hpp"

namespace echomap::bench {

/// How a staged end was told.
struct ToldEnd {
  std::string name;
  std::string why_not_run;               ///< Empty where it was run.
  int status = -1;                       ///< Exit code.
  std::string outcome;                   ///< Of summary.json; empty where nothing was saved.
  std::vector<std::string> differences;  ///< From its golden text.

  bool has_run() const { return why_not_run.empty(); }
  /// Its exit code, its outcome and its closing paragraph are as the golden text says.
  bool is_told() const { return has_run() && differences.empty(); }
};

/// Stages the end in `folder`, by the user's command. Reports on stderr how it was told.
ToldEnd tell_end(const test::StagedEnd& end, const std::filesystem::path& folder);

/// ends_told_of_12 counts the ends that are told as their golden texts say; one that was not run is
/// not told.
std::vector<Figure> told_figures(const std::vector<ToldEnd>& ends);

/// A row for each end.
MarkdownTable told_table(const std::vector<ToldEnd>& ends);

}  // namespace echomap::bench

// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/benchmarks/figures.hpp"
#include "tests/structure/papers_page.hpp"

namespace echomap::bench {

/// How `echomap paper NUMBER --runs 2 --headless` has ended.
struct MadeReport {
  std::string number;
  int exit_code = -1;
  bool has_page = false;  ///< It has left a report.html.
  double seconds = 0.0;   ///< Of the wall clock.

  bool is_made() const { return exit_code == 0 && has_page; }
};

/// Makes the report of a paper in `folder`, by the user's program.
MadeReport make_report(const std::string& number, const std::filesystem::path& folder);

/// features_listed and features_with_command: rows of docs/papers.md, and those with a command.
std::vector<Figure> feature_figures(const structure::PapersPage& page);

/// reports_of_5, those that are made, and seconds.NUMBER of each of these.
std::vector<Figure> report_figures(const std::vector<MadeReport>& reports);

/// Why there is no report, by its number.
Notes report_notes(const std::vector<MadeReport>& reports);

}  // namespace echomap::bench

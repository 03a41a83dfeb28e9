// SPDX-License-Identifier: MIT
// The five papers: how many of their features docs/papers.md shows by a command, and how many of
// their reports echomap makes, and how long that takes.
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "host/session/temporary_folder.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/paper_reports.hpp"
#include "tests/structure/papers_page.hpp"
#include "tests/structure/source_tree.hpp"

namespace echomap::bench {
namespace {

struct Options {
  std::vector<std::string> reports{"000", "001", "002", "003", "004"};
  std::filesystem::path json;
};

void run_papers(const Options& options) {
  const std::filesystem::path page = std::filesystem::path(ECHOMAP_SOURCE_DIR) / "docs/papers.md";
  std::vector<Figure> figures =
      feature_figures(structure::parse_papers_page(structure::read_lines(page)));
  const session::TemporaryFolder folder;
  std::vector<MadeReport> reports;
  for (const std::string& number : options.reports) {
    fmt::print(stderr, "report of paper {}\n", number);
    reports.push_back(make_report(number, folder.path()));
  }
  const std::vector<Figure> made = report_figures(reports);
  figures.insert(figures.end(), made.begin(), made.end());
  report(figures, options.json, report_notes(reports));
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  echomap::bench::Options options;
  CLI::App app("Features of the papers with a command, and reports of the papers");
  app.add_option("--reports", options.reports, "Only these papers, with commas between")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--json", options.json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  echomap::bench::run_papers(options);
}

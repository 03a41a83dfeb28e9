// SPDX-License-Identifier: MIT
#include "tests/benchmarks/told_ends.hpp"

#include <algorithm>
#include <exception>

#include <fmt/format.h>

namespace echomap::bench {
namespace {

std::string verdict_of(const ToldEnd& end) {
  return end.is_told() ? "yes" : end.has_run() ? "no" : "not run: " + end.why_not_run;
}

void print_end(const ToldEnd& end) {
  fmt::print(stderr, "{:16} told: {}\n", end.name, verdict_of(end));
  for (const std::string& difference : end.differences) {
    fmt::print(stderr, "  {}\n", difference);
  }
}

}  // namespace

ToldEnd tell_end(const test::StagedEnd& end, const std::filesystem::path& folder) {
  ToldEnd told;
  told.name = end.name;
  try {
    std::filesystem::create_directories(folder);
    const test::StagedRun run = test::drive(end, folder);
    told.status = run.ended.status;
    told.outcome = run.summary ? run.summary->value("outcome", "") : "";
    told.differences = test::differences(end, run);
  } catch (const std::exception& error) {
    told.why_not_run = error.what();
  }
  print_end(told);
  return told;
}

std::vector<Figure> told_figures(const std::vector<ToldEnd>& ends) {
  const auto told =
      std::count_if(ends.begin(), ends.end(), [](const ToldEnd& end) { return end.is_told(); });
  return {{"ends_told_of_12", static_cast<double>(told), "", ends.size(), {}}};
}

MarkdownTable told_table(const std::vector<ToldEnd>& ends) {
  MarkdownTable table{{"end", "exit code", "`outcome`", "told"}, {}};
  for (const ToldEnd& end : ends) {
    table.rows.push_back({end.name,
                          end.has_run() ? std::to_string(end.status) : "-",
                          end.outcome.empty() ? "-" : end.outcome,
                          verdict_of(end)});
  }
  return table;
}

}  // namespace echomap::bench

// SPDX-License-Identifier: MIT
#include "tests/benchmarks/paper_reports.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "host/session/child_process.hpp"

namespace echomap::bench {

MadeReport make_report(const std::string& number, const std::filesystem::path& folder) {
  const auto start = std::chrono::steady_clock::now();
  session::ChildProcess paper({(session::program_folder() / "echomap").string(),
                               "paper",
                               number,
                               "--runs=2",
                               "--headless",
                               "--out=" + (folder / number).string()},
                              folder / (number + ".log"));
  MadeReport made;
  made.number = number;
  made.exit_code = paper.wait_for(std::chrono::hours(1)).value_or(-1);
  made.has_page = std::filesystem::exists(folder / number / "report.html");
  made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return made;
}

std::vector<Figure> feature_figures(const structure::PapersPage& page) {
  std::size_t listed = 0;
  std::size_t shown = 0;
  for (const structure::PaperSection& paper : page.papers) {
    for (const structure::PaperFeature& feature : paper.features) {
      ++listed;
      shown += feature.commands.empty() ? 0 : 1;
    }
  }
  return {{"features_listed", static_cast<double>(listed), "", page.papers.size(), {}},
          {"features_with_command", static_cast<double>(shown), "", listed, {}}};
}

std::vector<Figure> report_figures(const std::vector<MadeReport>& reports) {
  const auto made = std::count_if(
      reports.begin(), reports.end(), [](const MadeReport& each) { return each.is_made(); });
  std::vector<Figure> figures{{"reports_of_5", static_cast<double>(made), "", reports.size(), {}}};
  for (const MadeReport& report : reports) {
    if (report.is_made()) {
      figures.push_back({"seconds." + report.number, report.seconds, "s", 1, {}});
    }
  }
  return figures;
}

Notes report_notes(const std::vector<MadeReport>& reports) {
  Notes notes;
  for (const MadeReport& report : reports) {
    if (report.exit_code != 0) {
      notes[report.number] = fmt::format("no report: exit code {}", report.exit_code);
    } else if (!report.has_page) {
      notes[report.number] = "no report: exit code 0, but no report.html";
    }
  }
  return notes;
}

}  // namespace echomap::bench

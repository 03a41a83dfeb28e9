// SPDX-License-Identifier: MIT
#include <cctype>
#include <cstdio>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/report.hpp"
#include "host/console/interrupt.hpp"
#include "host/console/print.hpp"
#include "host/console/progress_bar.hpp"
#include "host/console/shell_line.hpp"
#include "host/files/bundled_files.hpp"
#include "host/paper_report/report_directory.hpp"
#include "host/paper_report/report_json.hpp"
#include "host/papers/paper_list.hpp"

namespace echomap::apps {
namespace {

using paper_report::Finding;
using paper_report::Measured;

std::string words_of(const std::optional<Measured>& measured, const Finding& finding) {
  return measured ? paper_report::value_text(*measured, finding.unit, finding.decimals) +
                        paper_report::interval_text(*measured, finding.decimals)
                  : "-";
}

/// RFC 8089: a path as a link, all but letters, digits and -._~/ in percent code.
std::string file_url(const std::filesystem::path& path) {
  std::string url = "file://";
  for (const char c : std::filesystem::absolute(path).string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain =
        std::isalnum(byte) != 0 || std::string_view("-._~/").find(c) != std::string_view::npos;
    url += is_plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return url;
}

void print_findings(const paper_report::PaperReport& report) {
  for (const paper_report::Experiment& experiment : report.experiments) {
    console::print(fmt::format("{:<48} {:<34} {}", experiment.title, "as told", "our way"));
    for (const Finding& finding : experiment.findings) {
      console::print(fmt::format("  {:<46} {:<34} {}",
                                 finding.quantity,
                                 words_of(finding.as_told, finding),
                                 words_of(finding.ours, finding)));
    }
    console::print("  " + experiment.answer);
  }
}

}  // namespace

ExitCode run_paper(const PaperOptions& options) {
  const auto out = std::filesystem::absolute(run_folder(options.out));
  if (exists(out / "report.json") && !options.force) {
    throw CommandError(ExitCode::kUsage,
                       out.string() +
                           " has a report\n  next: name another folder with --out, or "
                           "add --force to replace it");
  }
  prepare_outputs(out, options.json, options.force);
  console::ProgressBar bar(stderr, !options.headless);
  papers::PaperSettings settings;
  settings.seed = options.seed;
  settings.runs = options.runs;
  settings.out = out;
  settings.progress = [&](const std::string& what, std::size_t ended, std::size_t runs) {
    if (console::interrupted()) {
      throw CommandError(ExitCode::kInterrupted, "interrupted: no report is written");
    }
    bar.show(static_cast<double>(ended) / static_cast<double>(runs), what);
  };
  paper_report::PaperReport report = papers::repeat_paper(options.number, settings);
  bar.clear();
  report.version = ECHOMAP_VERSION;
  report.command = fmt::format(
      "echomap paper {} --seed {} --runs {}", options.number, options.seed, options.runs);
  const auto root = files::bundled_folder("host").parent_path();
  const paper_report::SourceLines source_lines(root, file_url(root) + "/");
  paper_report::write_report(out, report, source_lines);
  print_findings(report);
  write_report(options.json,
               nlohmann::ordered_json::parse(paper_report::report_json(report, source_lines)));
  console::print("report: " + (out / "report.html").string() +
                 "\n  next: " + console::shell_line({"xdg-open", (out / "report.html").string()}));
  return ExitCode::kOk;
}

}  // namespace echomap::apps

// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host/paper_report/paper_report.hpp"
#include "host/paper_report/source_lines.hpp"

namespace echomap::paper_report {

/// Version of the layout of report.json. A reader that finds another one should stop.
constexpr int kReportJsonVersion = 1;

/// The report for programs, as one JSON object with the findings' numbers unrounded:
///
/// - `format` ("echomap-paper-report") and `version`: how to read the rest.
/// - `paper`: `number`, `title`, `authors`.
/// - `echomap_version`, `command`, `seed`: what repeats the report.
/// - `confidence`: the share that the intervals hold, 0.95.
/// - `experiments`: each with `title`, `question`, `answer`, `findings`, `pictures` (`file` is the
///   name of the PNG file beside the report), `equations` (`line` null where it is not found) and
///   `open`. In a finding `as_told` and `ours` are null or have `value`, `low`, `high` and `runs`,
///   in `unit`.
std::string report_json(const PaperReport& report, const SourceLines& source_lines);

/// Name of a picture's file: its number in the page and the letters and digits of its title, as in
/// "03_posterior_of_figure_8.png".
std::string picture_file_name(int number, const std::string& title);

}  // namespace echomap::paper_report

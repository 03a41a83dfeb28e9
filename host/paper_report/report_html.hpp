// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host/paper_report/paper_report.hpp"
#include "host/paper_report/source_lines.hpp"

namespace echomap::paper_report {

/// The report as one HTML page that holds its pictures and its style and reads nothing else. It is
/// for screens, light and dark, and for A4 paper. All texts are escaped.
std::string html_of(const PaperReport& report, const SourceLines& source_lines);

}  // namespace echomap::paper_report

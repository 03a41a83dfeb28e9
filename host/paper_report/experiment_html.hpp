// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host/paper_report/paper_report.hpp"
#include "host/paper_report/source_lines.hpp"

namespace echomap::paper_report {

/// The last numbers that a page has given to its parts; each kind counts from 1.
struct PageNumbers {
  int experiment = 0;
  int picture = 0;
  int table = 0;
};

/// One experiment as a `<section>` of the page: question, pictures, methods, table, answer,
/// equations and open questions. It continues the page's numbers.
std::string experiment_html(const Experiment& experiment,
                            const SourceLines& source_lines,
                            PageNumbers& numbers);

}  // namespace echomap::paper_report

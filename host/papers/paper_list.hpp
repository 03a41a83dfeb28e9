// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "host/paper_report/paper_report.hpp"
#include "host/papers/paper_settings.hpp"

namespace echomap::papers {

/// Numbers of the papers whose experiments can be repeated, such as "000".
std::vector<std::string> paper_numbers();

/// Repeats the experiments of the paper with that number. Throws std::out_of_range where there is
/// none, std::invalid_argument for no runs, and as `run_explorations`.
paper_report::PaperReport repeat_paper(const std::string& number, const PaperSettings& settings);

}  // namespace echomap::papers

// SPDX-License-Identifier: MIT
#pragma once

#include "host/paper_report/paper_report.hpp"
#include "host/papers/paper_settings.hpp"

namespace echomap::papers {

/// Repeats Monte-Carlo localization of the e-puck in its own grid, with and without Neff (Mahmood
/// and Ridao 2017, section 3.3, Algorithm 4; section 4.1, figures 4, 6 and 7). Throws
/// files::FileError for pictures that cannot be written.
paper_report::Experiment epuck_localization_experiment(const PaperSettings& settings);

}  // namespace echomap::papers

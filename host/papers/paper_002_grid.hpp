// SPDX-License-Identifier: MIT
#pragma once

#include "host/paper_report/paper_report.hpp"
#include "host/papers/paper_settings.hpp"

namespace echomap::papers {

/// Repeats the occupancy grid of the e-puck's field (Mahmood and Ridao 2017, section 3.2,
/// Algorithms 2 and 3; section 4.1, figure 5). Throws files::FileError for pictures that cannot be
/// written.
paper_report::Experiment epuck_grid_experiment(const PaperSettings& settings);

}  // namespace echomap::papers

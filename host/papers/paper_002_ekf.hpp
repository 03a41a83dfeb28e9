// SPDX-License-Identifier: MIT
#pragma once

#include "host/paper_report/paper_report.hpp"
#include "host/papers/paper_settings.hpp"

namespace echomap::papers {

/// Repeats EKF localization of an e-puck under an overhead camera (Mahmood and Ridao 2017, section
/// 3.1, Algorithm 1; section 4.1, figure 3). Throws files::FileError for pictures that cannot be
/// written.
paper_report::Experiment epuck_ekf_experiment(const PaperSettings& settings);

}  // namespace echomap::papers

// SPDX-License-Identifier: MIT
#pragma once

#include "host/paper_report/paper_report.hpp"
#include "host/papers/paper_settings.hpp"

namespace echomap::papers {

/// Repeats what Akzhalova and Polichshuk show and announce: EKF-SLAM on the Edmonton log, which
/// `public_logs` need not have, and in a simulated hall; with the sonar of an Arduino in a small
/// room; a map and a search that two robots share. Throws as `run_explorations`, and
/// files::FileError for a damaged log.
paper_report::PaperReport paper_004(const PaperSettings& settings);

}  // namespace echomap::papers

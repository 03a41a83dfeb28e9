// SPDX-License-Identifier: MIT
#pragma once

#include "host/paper_report/paper_report.hpp"
#include "host/papers/paper_settings.hpp"

namespace echomap::papers {

/// Repeats the experiments of Mukherjee et al., as told and as echomap does the same: an iRobot
/// Create draws the outline of its room by following the walls, and is localized in it by its
/// contacts. Throws as `run_explorations`.
paper_report::PaperReport paper_001(const PaperSettings& settings);

}  // namespace echomap::papers

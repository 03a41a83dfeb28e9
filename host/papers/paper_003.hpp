// SPDX-License-Identifier: MIT
#pragma once

#include "host/paper_report/paper_report.hpp"
#include "host/papers/paper_settings.hpp"

namespace echomap::papers {

/// Repeats the experiments of Hennessey, Kapur and Singh, as told and as echomap does the same: a
/// LEGO EV3 goes through a door to the corners of its playground and back, maps it by Gaussian
/// patches, and has the cone of its sonar measured. Throws as `run_explorations`.
paper_report::PaperReport paper_003(const PaperSettings& settings);

}  // namespace echomap::papers

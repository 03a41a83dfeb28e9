// SPDX-License-Identifier: MIT
#pragma once

#include "host/paper_report/paper_report.hpp"
#include "host/papers/paper_settings.hpp"

namespace echomap::papers {

/// Repeats the experiments of Singh and Bedi 2013, as told and as echomap does the same: a LEGO NXT
/// maps its room by the farthest echoes, and is carried off and localized in that map. Throws as
/// `run_explorations`.
paper_report::PaperReport paper_000(const PaperSettings& settings);

}  // namespace echomap::papers

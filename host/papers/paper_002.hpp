// SPDX-License-Identifier: MIT
#pragma once

#include "host/paper_report/paper_report.hpp"
#include "host/papers/paper_settings.hpp"

namespace echomap::papers {

/// Repeats the experiments of Mahmood and Ridao 2017 with an e-puck under an overhead camera.
/// Throws files::FileError for pictures that cannot be written.
paper_report::PaperReport paper_002(const PaperSettings& settings);

}  // namespace echomap::papers

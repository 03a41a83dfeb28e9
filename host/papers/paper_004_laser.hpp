// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/paper_report/paper_report.hpp"
#include "host/papers/paper_settings.hpp"

namespace echomap::papers {

/// The Edmonton log below `logs`: the path by the paper's equations against EKF-SLAM. Where the log
/// is absent the experiment says which files to put where. Throws files::FileError for a damaged
/// log.
paper_report::Experiment edmonton_experiment(const PaperSettings& settings,
                                             const std::filesystem::path& logs);

/// The same in a simulated hall, whose true path and walls are known.
paper_report::Experiment hall_experiment(const PaperSettings& settings);

}  // namespace echomap::papers

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "host/datasets/log_record.hpp"
#include "host/evaluation/relation_error.hpp"
#include "host/geometry/pose2.hpp"
#include "host/slam/landmark_slam.hpp"

namespace echomap::bench {

/// The Edmonton log in the paper's form, and what is known of the ways between its scans.
struct EdmontonLog {
  std::vector<datasets::LogRecord> records;
  std::vector<evaluation::PoseRelation> relations;
};

/// Empty where the data is not there. Throws files::FileError.
std::optional<EdmontonLog> read_edmonton();

/// Poses of the scans by the paper's equations 1 to 3.
std::vector<geometry::Pose2> paper_odometry(const EdmontonLog& log);

/// Runs landmark SLAM over the log.
void run_edmonton(const EdmontonLog& log, slam::LandmarkSlam& method);

}  // namespace echomap::bench

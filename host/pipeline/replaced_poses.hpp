// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "host/datasets/log_reader.hpp"
#include "host/geometry/pose2.hpp"
#include "host/pipeline/log_poses.hpp"

namespace echomap::pipeline {

/// A log with other poses: in place of each record that says where the robot is by its odometry
/// stands one of `trajectory` as given, in their order (LogSlam's). Poses that the log itself gives
/// are left out.
class ReplacedPoses final : public datasets::LogReader {
 public:
  ReplacedPoses(std::unique_ptr<datasets::LogReader> log, std::vector<geometry::Pose2> trajectory);

  /// Throws files::FileError as the log does. Odometry beyond the end of the trajectory has no
  /// pose.
  std::optional<datasets::LogRecord> next() override;
  double progress() const override { return log_->progress(); }

 private:
  std::unique_ptr<datasets::LogReader> log_;
  std::vector<geometry::Pose2> trajectory_;
  std::size_t used_ = 0;
  LogPoses poses_{PoseSource::kOdometry};
};

}  // namespace echomap::pipeline

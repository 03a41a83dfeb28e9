// SPDX-License-Identifier: MIT
#include "host/pipeline/replaced_poses.hpp"

#include <utility>
#include <variant>

namespace echomap::pipeline {

namespace {

bool is_given(const datasets::LogRecord& record) {
  return std::holds_alternative<datasets::GivenPose>(record) ||
         std::holds_alternative<datasets::GivenPosition>(record);
}

}  // namespace

ReplacedPoses::ReplacedPoses(std::unique_ptr<datasets::LogReader> log,
                             std::vector<geometry::Pose2> trajectory)
    : log_(std::move(log)), trajectory_(std::move(trajectory)) {}

std::optional<datasets::LogRecord> ReplacedPoses::next() {
  auto record = log_->next();
  while (record && is_given(*record)) {
    record = log_->next();
  }
  if (!record || !poses_.follow(*record)) {
    return record;
  }
  if (used_ == trajectory_.size()) {
    return std::nullopt;
  }
  return datasets::GivenPose{datasets::stamp_s(*record), trajectory_[used_++]};
}

}  // namespace echomap::pipeline

// SPDX-License-Identifier: MIT
#include "host/session/robot_context.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>

#include "host/exploration/atlas_explorer.hpp"
#include "host/session/pipeline_setup.hpp"

namespace echomap::session {

void RobotContext::begin_maps(const std::string& slam) {
  atlas_.emplace(atlas_for(profile_, slam));
  slam_ = atlas_->pipeline().slam() != nullptr ? slam : kNoSlam;
  fork_.add(*atlas_);
}

void RobotContext::end_maps() {
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): begin_maps() comes before
  fork_.remove(*atlas_);
  if (self_check_) {
    fork_.remove(*self_check_);
  }
  if (follower_) {
    fork_.remove(follower_->sink());
    follower_.reset();
  }
}

void RobotContext::follow(std::unique_ptr<Follower> follower) {
  follower_ = std::move(follower);
  if (!follower_) {
    return;
  }
  if (atlas_) {
    fork_.remove(*atlas_);
  }
  fork_.add(follower_->sink());
  if (atlas_) {
    fork_.add(*atlas_);
  }
}

void RobotContext::open(OpenedRobot robot) {
  if (profile_.has_sonar) {
    self_check_.emplace(profile_.geometry, surface_params(profile_));
    fork_.add(*self_check_);
  }
  lockstep_ = std::move(robot.lockstep);
  session_.emplace(std::move(robot.connection), profile_, sessions_);
  session_->on_step = [this] {
    if (follower_) {
      follower_->poll(*session_);
    }
    if (on_step) {
      on_step();
    }
  };
}

void RobotContext::connect() {
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): open() comes before
  session_->connect();
  if (follower_) {
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): open() comes before
    follower_->begin(*session_);
  }
}

exploration::MotionResult RobotContext::execute(const exploration::Motion& motion) {
  if (!atlas_) {
    throw std::logic_error("RobotContext::execute: begin_maps comes first");
  }
  const auto changed = exploration::change_maps(*atlas_, motion);
  return changed ? *changed : move(motion);
}

exploration::MotionResult RobotContext::move(const exploration::Motion& motion) {
  if (self_check_) {
    self_check_->begin_motion(motion);
  }
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): open() comes before
  const exploration::MotionResult result = session_->execute(motion);
  if (self_check_) {
    self_check_->end_motion(result);
  }
  return result;
}

std::optional<diagnosis::Diagnosis> RobotContext::diagnosis() const {
  return self_check_ ? self_check_->diagnosis() : std::nullopt;
}

std::optional<diagnosis::FaultKind> RobotContext::wheel_that_stood_still() const {
  return self_check_ ? self_check_->stood_still() : std::nullopt;
}

double now_s(const RobotSession& session) {
  return std::chrono::duration<double>(session.now().time_since_epoch()).count();
}

}  // namespace echomap::session

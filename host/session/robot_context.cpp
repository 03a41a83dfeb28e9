// SPDX-License-Identifier: MIT
#include "host/session/robot_context.hpp"

#include <chrono>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

#include <spdlog/spdlog.h>

#include "host/exploration/atlas_explorer.hpp"
#include "host/session/fault_advice.hpp"
#include "host/session/pipeline_setup.hpp"

namespace echomap::session {
namespace {

using recording::SessionEventKind;

recording::SessionRecorderParams recorder_params(const RobotProfile& profile) {
  recording::SessionRecorderParams params;
  params.geometry = profile.geometry;
  params.sonar = {
      profile.beam_half_angle_rad, profile.range.min_range_m, profile.range.max_range_m};
  params.T_robot_infrared.reserve(profile.sensors.infrared.size());
  for (const sensors::InfraredSensor& sensor : profile.sensors.infrared) {
    params.T_robot_infrared.push_back(sensor.T_robot_sensor);
  }
  if (profile.sensors.scalar) {
    params.scalar_unit = profile.sensors.scalar->unit;
  }
  return params;
}

std::uint64_t nanoseconds_since_1970() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::nanoseconds>(since).count());
}

/// The decision about the maps that a motion is; empty for a motion of the robot.
std::optional<recording::SessionEvent> event_of(const exploration::Motion& motion) {
  if (const auto* begin = std::get_if<exploration::BeginNewMap>(&motion)) {
    return recording::SessionEvent{
        SessionEventKind::kBeginNewMap, static_cast<std::int64_t>(begin->stops_elsewhere), {}};
  }
  return std::holds_alternative<exploration::JoinMaps>(motion)
             ? std::optional(recording::SessionEvent{SessionEventKind::kJoinMaps, 0, {}})
             : std::nullopt;
}

}  // namespace

RobotContext::RobotContext(RobotProfile profile, const Seed& seed)
    : profile_(std::move(profile)),
      seed_(seed),
      recorder_(recorder_params(profile_)),
      encoder_check_(profile_.geometry) {
  recorder_.describe("robot.toml", profile_.toml);
  fork_.add(recorder_);
}

void RobotContext::begin_maps(const std::string& slam) {
  atlas_.emplace(atlas_for(profile_, slam));
  slam_ = atlas_->pipeline().slam() != nullptr ? slam : kNoSlam;
  maps_ = &*atlas_;
  fork_.add(*maps_);
}

void RobotContext::put_before_maps(pipeline::ObservationSink& sink) {
  fork_.replace(*maps_, sink);
  maps_ = &sink;
}

void RobotContext::end_maps() {
  recorder_.add_event({SessionEventKind::kEndMaps, 0, {}});
  fork_.remove(*maps_);
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
  if (maps_ != nullptr) {
    fork_.remove(*maps_);
  }
  fork_.add(follower_->sink());
  if (maps_ != nullptr) {
    fork_.add(*maps_);
  }
}

void RobotContext::open(OpenedRobot robot) {
  if (profile_.has_sonar) {
    fork_.add(sonar_check_);
    self_check_.emplace(profile_.geometry, surface_params(profile_));
    fork_.add(*self_check_);
  }
  fork_.add(encoder_check_);
  lockstep_ = std::move(robot.lockstep);
  remember_port_ = std::move(robot.remember_port);
  recorder_.begin_session(lockstep_ ? 0 : nanoseconds_since_1970());
  robot.connection.recorder = &recorder_;
  if (lockstep_) {
    robot.connection.pace = scaled_pace(std::move(robot.connection.pace), time_scale_);
  }
  session_ = std::make_unique<RobotSession>(std::move(robot.connection), profile_, sessions_);
  session_->on_step = [this] { step(); };
}

void RobotContext::obey(OperatorQueue& queue,
                        const OperatorParams& params,
                        const OperatorHooks& hooks) {
  person_.emplace(queue, params, hooks);
}

void RobotContext::step() {
  if (person_) {
    if (person_->poll(std::chrono::steady_clock::now())) {
      session_->halt();
    }
    const OperatorMode mode = person_->mode();
    const bool is_lost = session_->link().state() == robot_link::LinkState::kLost;
    time_scale_.keep_real_time(mode == OperatorMode::kDriving || mode == OperatorMode::kStopped ||
                               is_lost);
  }
  if (follower_) {
    follower_->poll(*session_);
  }
  look_for_trouble();
  for (const auto& on_step : listeners_) {
    on_step();
  }
}

void RobotContext::connect() {
  session_->connect();
  if (remember_port_) {
    remember_port_();
  }
  if (follower_) {
    follower_->begin(*session_);
  }
}

exploration::MotionResult RobotContext::execute(const exploration::Motion& motion) {
  if (!atlas_) {
    throw std::logic_error("RobotContext::execute: begin_maps comes first");
  }
  if (const auto event = event_of(motion)) {
    recorder_.add_event(*event);
  }
  const auto changed = exploration::change_maps(*atlas_, motion);
  const exploration::MotionResult result = changed ? *changed : move(motion);
  if (changed == exploration::MotionResult::kReached ||
      std::holds_alternative<exploration::EndScan>(motion)) {
    recorder_.add_map(atlas_->pipeline().snapshot());
  }
  return result;
}

void RobotContext::look_for_trouble() {
  if (!recorder_.trouble().empty() && !std::exchange(trouble_is_reported_, true)) {
    spdlog::warn("cannot record: {}; trying again", recorder_.trouble());
  }
  if (sonar_is_dead() != std::exchange(dead_sonar_is_reported_, sonar_is_dead())) {
    spdlog::warn(sonar_is_dead() ? "the sonar does not answer: it is not connected, or it is dead; "
                                   "check its wiring and its supply (docs/guides/wiring.md)"
                                 : "the sonar answers again");
  }
  if (const auto& dirt = dirty_encoder(); dirt && !std::exchange(dirt_is_reported_, true)) {
    const FaultAdvice advice = advice_of(*dirt, profile_);
    spdlog::warn("{}: {}", advice.what, advice.change);
  }
}

exploration::MotionResult RobotContext::move(const exploration::Motion& motion) {
  OperatorControl* const person = person_ ? &*person_ : nullptr;
  if (person != nullptr && person->has_robot()) {
    return hand_over(*person);
  }
  const std::size_t times_taken = person != nullptr ? person->times_taken() : 0;
  if (self_check_) {
    self_check_->begin_motion(motion);
  }
  const exploration::MotionResult result = session_->execute(motion);
  if (self_check_) {
    self_check_->end_motion(result);
  }
  return person != nullptr && person->times_taken() != times_taken ? hand_over(*person) : result;
}

exploration::MotionResult RobotContext::hand_over(OperatorControl& person) {
  session_->end_scan();
  exploration::MotionResult last = exploration::MotionResult::kTakenOver;
  while (person.has_robot() && !session_->end()) {
    const auto snapshot = atlas_ ? atlas_->pipeline().snapshot() : pipeline::Snapshot();
    last = session_->execute(person.next(snapshot, last));
  }
  return exploration::MotionResult::kTakenOver;
}

std::optional<diagnosis::Diagnosis> RobotContext::diagnosis() const {
  const auto found = self_check_ ? self_check_->diagnosis() : std::nullopt;
  const auto& dirt = dirty_encoder();
  if (dirt && explains(*dirt, found ? found->fault.kind : diagnosis::FaultKind::kNone)) {
    return diagnosis::Diagnosis{*dirt, std::numeric_limits<double>::infinity(), 0};
  }
  return found;
}

std::optional<diagnosis::FaultKind> RobotContext::wheel_that_stood_still() const {
  return self_check_ ? self_check_->stood_still() : std::nullopt;
}

double now_s(const RobotSession& session) {
  return std::chrono::duration<double>(session.now().time_since_epoch()).count();
}

}  // namespace echomap::session

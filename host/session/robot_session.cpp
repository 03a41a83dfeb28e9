// SPDX-License-Identifier: MIT
#include "host/session/robot_session.hpp"

#include <utility>
#include <variant>

#include "host/console/exit_code.hpp"
#include "host/session/connect_failure.hpp"

namespace echomap::session {
namespace {

using exploration::MotionResult;
using robot_link::LinkState;

/// A board that was reset by opening its port needs 2.5 s to come up.
constexpr std::chrono::seconds kConnectLimit(5);
/// A predecessor that did not take its leave holds the robot for 2.5 s.
constexpr std::chrono::seconds kBusyLimit(4);
/// A sweep that a reset broke off is done again.
constexpr int kSweepTries = 3;

}  // namespace

RobotSession::RobotSession(RobotConnection robot,
                           const RobotProfile& profile,
                           pipeline::ObservationSink& sink)
    : no_reset_(robot.no_reset),
      profile_(profile),
      sink_(sink),
      line_(std::move(robot), profile_, sink),
      setup_(line_, profile_),
      motions_(line_, profile_) {
  line_.on_step = [this] {
    if (on_step) {
      on_step();
    }
  };
}

RobotSession::~RobotSession() {
  line_.on_step = nullptr;
  disarm();
}

void RobotSession::connect() {
  std::optional<time::HostTime> busy_since;
  const auto settled = [&] {
    const LinkState state = link().state();
    busy_since = state == LinkState::kBusy ? busy_since.value_or(now()) : busy_since;
    return state == LinkState::kReady || state == LinkState::kMismatch ||
           (busy_since && now() - *busy_since > kBusyLimit);
  };
  line_.begin();
  line_.wait_until(settled, kConnectLimit);
  if (const auto ended = end()) {
    throw console::CommandError(exit_code_of(*ended), end_reason());
  }
  if (link().state() != LinkState::kReady) {
    throw console::CommandError(connect_failure(link()),
                                reason_of_connect_failure(link(), line_.name()));
  }
  line_.hold_on();
  throw_if_reset();
  if (!setup_.set_up()) {
    throw console::CommandError(exit_code_of(end().value_or(SessionEnd::kLinkLost)), end_reason());
  }
}

void RobotSession::throw_if_reset() {
  if (!no_reset_) {
    return;
  }
  line_.wait_until([&] { return start_of_robot(link()).has_value(); }, kConnectLimit);
  if (was_reset_since(time::HostTime{}, link())) {
    throw console::CommandError(console::ExitCode::kNoRobot, reset_by_opening(line_.name()));
  }
}

bool RobotSession::be_ready() {
  return line_.wait_until_ready() && (!line_.was_reset() || setup_.set_up());
}

MotionResult RobotSession::execute(const exploration::Motion& motion) {
  motions_.let_go();
  if (!be_ready()) {
    return MotionResult::kInterrupted;
  }
  if (const auto* turn = std::get_if<exploration::Turn>(&motion)) {
    return motions_.move(profile_.geometry.turn_on_spot(turn->angle_rad));
  }
  if (const auto* drive = std::get_if<exploration::Drive>(&motion)) {
    return motions_.move(profile_.geometry.straight(drive->distance_m));
  }
  if (const auto* arc = std::get_if<exploration::Roll>(&motion)) {
    return motions_.roll(*arc);
  }
  if (const auto* pan = std::get_if<exploration::Sweep>(&motion)) {
    return sweep(*pan);
  }
  if (const auto* pause = std::get_if<exploration::Stand>(&motion)) {
    return motions_.stand(*pause);
  }
  if (std::holds_alternative<exploration::BeginScan>(motion)) {
    sink_.begin_scan();
  } else if (std::holds_alternative<exploration::EndScan>(motion)) {
    end_scan();
  }
  return MotionResult::kReached;
}

MotionResult RobotSession::sweep(const exploration::Sweep& sweep) {
  MotionResult result = MotionResult::kInterrupted;
  for (int i = 0; i < kSweepTries && result == MotionResult::kInterrupted &&
                  !motions_.is_halted() && be_ready();
       ++i) {
    result = motions_.sweep(sweep);
  }
  return result;
}

}  // namespace echomap::session

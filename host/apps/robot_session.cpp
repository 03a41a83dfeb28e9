// SPDX-License-Identifier: MIT
#include "host/apps/robot_session.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>
#include <variant>

#include <spdlog/spdlog.h>

#include "host/apps/exit_code.hpp"
#include "host/apps/interrupt.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::apps {
namespace {

using exploration::MotionResult;
using robot_link::CommandOutcome;
using robot_link::LinkState;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Duration = time::HostClock::duration;

/// A board that was reset by opening its port needs 2.5 s to come up.
constexpr seconds kConnectLimit(5);
/// The robot goes on by itself for this long after the link broke; then the run ends.
constexpr seconds kLostLimit(3);
constexpr milliseconds kTimeToLive(200);
/// After a move, until the body has come to rest.
constexpr milliseconds kRest(150);

Duration seconds_of(double value_s) { return Duration(std::llround(value_s * 1e6)); }

std::int16_t centidegrees(double angle_rad) {
  return static_cast<std::int16_t>(std::lround(geometry::degrees(angle_rad) * 100.0));
}

MotionResult result_of(protocol::MotionOutcome outcome) {
  switch (outcome) {
    case protocol::MotionOutcome::kReached:
      return MotionResult::kReached;
    case protocol::MotionOutcome::kBumped:
      return MotionResult::kBumped;
    case protocol::MotionOutcome::kStalled:
      return MotionResult::kStalled;
    default:
      return MotionResult::kTimedOut;
  }
}

}  // namespace

RobotSession::RobotSession(std::unique_ptr<transport::ByteStream> stream,
                           std::unique_ptr<Pace> pace,
                           const RobotProfile& profile,
                           std::uint16_t session_id,
                           pipeline::RobotPipeline& pipeline)
    : stream_(std::move(stream)),
      pace_(std::move(pace)),
      profile_(profile),
      pipeline_(pipeline),
      converter_(profile.geometry, profile.range),
      link_(*this, session_id) {}

void RobotSession::connect() {
  const auto settled = [&] {
    const LinkState state = link_.state();
    return state == LinkState::kReady || state == LinkState::kMismatch;
  };
  wait_until(settled, kConnectLimit);
  if (end_) {
    throw CommandError(
        *end_ == SessionEnd::kInterrupted ? ExitCode::kInterrupted : ExitCode::kLinkLost,
        end_reason_);
  }
  if (link_.state() != LinkState::kReady) {
    fail_to_connect();
  }
  set_up_robot();
}

void RobotSession::fail_to_connect() const {
  const std::string port = stream_->name();
  if (const auto& mismatch = link_.mismatch()) {
    throw CommandError(ExitCode::kFirmwareMismatch, mismatch->message());
  }
  switch (link_.state()) {
    case LinkState::kGarbage:
      throw CommandError(ExitCode::kNoRobot,
                         "bytes come from " + port +
                             ", but no echomap frame is among them: another program runs on that "
                             "board, or the baud rate is another one\n  what came first:\n" +
                             link_.preview().text() + "  next: ./run flash --port " + port +
                             ", or try --baud 250000");
    case LinkState::kUnheard:
      throw CommandError(ExitCode::kNoRobot,
                         "a robot talks on " + port +
                             " but does not hear us\n  next: check the wire to the board's RX pin");
    default:
      throw CommandError(ExitCode::kNoRobot,
                         "nothing answers on " + port +
                             "\n  next: is the robot switched on and flashed? ./run flash --port " +
                             port);
  }
}

/// Sends the profile and arms; a robot that was reset in mid-run needs it again.
void RobotSession::set_up_robot() {
  for (const robot_link::Command& command : {robot_link::Command(profile_.drive),
                                             robot_link::Command(profile_.sonar),
                                             robot_link::Command(protocol::Arm{0, 1})}) {
    const auto result = perform(command);
    if (result && result->outcome == CommandOutcome::kOutOfRange) {
      throw CommandError(
          ExitCode::kConfigInvalid,
          "the board refuses a number of profile '" + profile_.name + "': out of its range");
    }
  }
  resets_ = 0;
}

MotionResult RobotSession::execute(const exploration::Motion& motion) {
  if (resets_ > 0) {
    set_up_robot();
  }
  if (const auto* turn = std::get_if<exploration::Turn>(&motion)) {
    return move(profile_.geometry.turn_on_spot(turn->angle_rad));
  }
  if (const auto* drive = std::get_if<exploration::Drive>(&motion)) {
    return move(profile_.geometry.straight(drive->distance_m));
  }
  if (const auto* pan = std::get_if<exploration::Sweep>(&motion)) {
    return sweep(*pan);
  }
  if (std::holds_alternative<exploration::BeginScan>(motion)) {
    pipeline_.begin_scan();
  } else if (std::holds_alternative<exploration::EndScan>(motion)) {
    pipeline_.end_scan();
  }
  return MotionResult::kReached;
}

MotionResult RobotSession::move(const sensors::WheelTicks& ticks) {
  const auto longest = std::max(std::abs(ticks.left), std::abs(ticks.right));
  const double ramp_s = 2.0 * profile_.ticks_per_s() / profile_.drive.max_ticks_per_s2;
  const double expected_s = static_cast<double>(longest) / profile_.ticks_per_s() + ramp_s;

  link_.keep_alive(true);
  const MotionResult result =
      finish(protocol::MoveTicks{0,
                                 ticks.left,
                                 ticks.right,
                                 profile_.ticks_per_s(),
                                 static_cast<std::uint16_t>(kTimeToLive.count())},
             seconds_of(expected_s));
  wait_until([] { return false; }, kRest);
  link_.keep_alive(false);
  return result;
}

MotionResult RobotSession::sweep(const exploration::Sweep& sweep) {
  const double steps = std::abs((sweep.to_rad - sweep.from_rad) / sweep.step_rad) + 1.0;
  const double step_s = sweep.settle_s + 0.15;
  return finish(protocol::StartSweep{0,
                                     centidegrees(sweep.from_rad),
                                     centidegrees(sweep.to_rad),
                                     centidegrees(sweep.step_rad),
                                     static_cast<std::uint16_t>(std::lround(sweep.settle_s * 1e3))},
                seconds_of(steps * step_s + 1.0));
}

/// Sends the command and waits until the robot's Status says that its motion has ended.
MotionResult RobotSession::finish(const robot_link::Command& command, Duration expected) {
  const auto result = perform(command);
  if (!result || result->outcome != CommandOutcome::kAccepted) {
    const bool blocked = result && result->outcome == CommandOutcome::kBlocked;
    return blocked ? MotionResult::kBumped : MotionResult::kRefused;
  }
  const bool is_sweep = std::holds_alternative<protocol::StartSweep>(command);
  const auto outcome = [&] {
    const bool ours =
        status_ && (is_sweep ? status_->sweep_id : status_->move_id) == result->command_id;
    return ours ? static_cast<protocol::MotionOutcome>(is_sweep ? status_->sweep_outcome
                                                                : status_->move_outcome)
                : protocol::MotionOutcome::kRunning;
  };
  const auto ended = [&] { return resets_ > 0 || outcome() != protocol::MotionOutcome::kRunning; };
  if (!wait_until(ended, 2 * expected + seconds(3))) {
    perform(protocol::Stop{});
    return MotionResult::kTimedOut;
  }
  return result_of(outcome());
}

std::optional<robot_link::CommandResult> RobotSession::perform(const robot_link::Command& command) {
  result_.reset();
  link_.submit(command);
  wait_until([&] { return result_.has_value(); }, seconds(5));
  return result_;
}

void RobotSession::disarm() {
  if (stream_->status() != transport::StreamStatus::kOpen || !pace_->end_reason().empty()) {
    return;
  }
  link_.keep_alive(false);
  result_.reset();
  link_.submit(protocol::Arm{0, 0});
  for (int i = 0; i < 100 && !result_; ++i) {
    step();
  }
}

bool RobotSession::wait_until(const std::function<bool()>& done, Duration limit) {
  const time::HostTime start = now_;
  while (!end_ && !done() && now_ - start < limit) {
    step();
    look_for_end();
  }
  return done();
}

void RobotSession::step() {
  const auto outgoing = link_.take_outgoing();
  stream_->write(outgoing);
  bytes_sent_ += outgoing.size();
  std::vector<std::uint8_t> received;
  now_ = pace_->step(*stream_, bytes_sent_, [&](std::span<const std::uint8_t> bytes) {
    received.insert(received.end(), bytes.begin(), bytes.end());
  });
  link_.receive(received, now_);
  link_.poll(now_);
  if (on_step) {
    on_step();
  }
}

void RobotSession::look_for_end() {
  if (interrupted()) {
    end_ = SessionEnd::kInterrupted;
    end_reason_ = "interrupted";
    return;
  }
  const bool closed = stream_->status() == transport::StreamStatus::kClosed;
  if (closed || !pace_->end_reason().empty()) {
    end_ = SessionEnd::kLinkLost;
    end_reason_ =
        "lost " + stream_->name() + ": " + (closed ? stream_->close_reason() : pace_->end_reason());
    return;
  }
  if (link_.state() != LinkState::kLost) {
    lost_since_.reset();
  } else if (!lost_since_) {
    lost_since_ = now_;
  } else if (now_ - *lost_since_ > kLostLimit) {
    end_ = SessionEnd::kLinkLost;
    end_reason_ = "lost " + stream_->name() + ": the robot has fallen silent";
  }
}

std::optional<unsigned> RobotSession::stack_free_bytes() const {
  return status_ ? std::optional<unsigned>(status_->stack_free_bytes) : std::nullopt;
}

void RobotSession::on_odometry(const protocol::Odometry& message) {
  pipeline_.on_odometry(converter_.convert(message));
}

void RobotSession::on_echo(const protocol::Echo& message) {
  pipeline_.on_sonar(converter_.convert(message));
}

void RobotSession::on_status(const protocol::Status& message) { status_ = message; }

void RobotSession::on_ready(const protocol::HelloReply& reply) {
  spdlog::debug("robot ready: firmware {}.{:02}, boot {:04x}",
                reply.firmware_version / 100,
                reply.firmware_version % 100,
                reply.boot_id);
}

void RobotSession::on_reset(std::uint8_t reset_cause) {
  spdlog::warn(
      "the robot was reset (cause bits {:#x}); the pose is kept and the robot set up again",
      reset_cause);
  converter_.restart();
  status_.reset();
  ++resets_;
}

void RobotSession::on_command_done(const robot_link::CommandResult& result) { result_ = result; }

}  // namespace echomap::apps

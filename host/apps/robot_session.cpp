// SPDX-License-Identifier: MIT
#include "host/apps/robot_session.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>
#include <variant>

#include <spdlog/spdlog.h>

#include "host/apps/configuration_check.hpp"
#include "host/apps/connect_failure.hpp"
#include "host/apps/exit_code.hpp"
#include "host/apps/interrupt.hpp"
#include "host/geometry/angle.hpp"
#include "protocol/config_digest.hpp"

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
/// For a command under way and the disarming behind it, with resends.
constexpr seconds kDisarmLimit(1);
/// After a move, until the body has come to rest.
constexpr milliseconds kRest(150);
/// Setting up is begun anew when the board was reset in the middle of it, which a servo's first
/// start on a weak supply does.
constexpr int kSetUpTries = 5;
/// For the whole of a configuration, with resends.
constexpr seconds kBulkLimit(5);
/// A sweep that a reset broke off is done again.
constexpr int kSweepTries = 3;

Duration seconds_of(double value_s) { return Duration(std::llround(value_s * 1e6)); }

std::int32_t centidegrees(double angle_rad) {
  return static_cast<std::int32_t>(std::lround(geometry::degrees(angle_rad) * 100.0));
}

/// Why the board has stopped and disarmed by itself; empty for any other outcome.
std::string_view safety_stop(protocol::MotionOutcome outcome) {
  switch (outcome) {
    case protocol::MotionOutcome::kLifted:
      return "the robot was lifted, and its pose is not known any more";
    case protocol::MotionOutcome::kRunaway:
      return "a wheel turned against its command: check the inversions of motors and encoders in "
             "the profile";
    case protocol::MotionOutcome::kOverSpeed:
      return "a wheel was faster than the profile allows";
    default:
      return {};
  }
}

/// What a command that was not accepted means for the motion.
MotionResult refusal_of(CommandOutcome outcome) {
  switch (outcome) {
    case CommandOutcome::kBlocked:
      return MotionResult::kBumped;
    case CommandOutcome::kLinkLost:
    case CommandOutcome::kRobotReset:
      return MotionResult::kInterrupted;
    default:
      return MotionResult::kRefused;
  }
}

}  // namespace

ExitCode exit_code_of(SessionEnd end) {
  switch (end) {
    case SessionEnd::kInterrupted:
      return ExitCode::kInterrupted;
    case SessionEnd::kSafetyStop:
      return ExitCode::kSafetyStop;
    case SessionEnd::kLinkLost:
      break;
  }
  return ExitCode::kLinkLost;
}

RobotSession::RobotSession(RobotConnection robot,
                           const RobotProfile& profile,
                           pipeline::RobotPipeline& pipeline)
    : stream_(std::move(robot.stream)),
      pace_(std::move(robot.pace)),
      patience_(robot.patience),
      no_reset_(robot.no_reset),
      time_to_live_ms_(static_cast<std::uint16_t>(
          std::chrono::duration_cast<milliseconds>(robot.link.keep_alive_ttl).count())),
      profile_(profile),
      pipeline_(pipeline),
      converter_(profile.geometry, profile.range, profile.sensors),
      link_(*this, robot.session_id, robot.link) {}

RobotSession::~RobotSession() { disarm(); }

void RobotSession::connect() {
  const auto settled = [&] {
    const LinkState state = link_.state();
    return state == LinkState::kReady || state == LinkState::kMismatch;
  };
  wait_until(settled, kConnectLimit);
  if (end_) {
    throw CommandError(exit_code_of(end_.value_or(SessionEnd::kLinkLost)), end_reason_);
  }
  if (link_.state() != LinkState::kReady) {
    throw CommandError(connect_failure(link_), reason_of_connect_failure(link_, stream_->name()));
  }
  connected_ = true;
  check_it_was_not_reset();
  if (!set_up_robot()) {
    throw CommandError(exit_code_of(end_.value_or(SessionEnd::kLinkLost)), end_reason_);
  }
}

void RobotSession::check_it_was_not_reset() {
  if (!no_reset_) {
    return;
  }
  wait_until([&] { return link_.clock().host_time(0).has_value(); }, kConnectLimit);
  if (was_reset_since(time::HostTime{}, link_)) {
    throw CommandError(ExitCode::kNoRobot, reset_by_opening(stream_->name()));
  }
}

bool RobotSession::be_ready() {
  const auto ready = [&] { return link_.state() == LinkState::kReady; };
  return wait_until(ready, Duration::max()) && (resets_ == 0 || set_up_robot());
}

/// Until the board has taken all of its profile since one and the same start.
bool RobotSession::set_up_robot() {
  for (int i = 0; i < kSetUpTries && !end_; ++i) {
    if (try_to_set_up()) {
      return true;
    }
  }
  end(SessionEnd::kLinkLost, "the robot on " + stream_->name() + " is reset again and again");
  return false;
}

bool RobotSession::try_to_set_up() {
  resets_ = 0;
  if (!configure()) {
    return false;
  }
  const auto armed = perform(protocol::Arm{0, 1});
  if (armed && armed->outcome == CommandOutcome::kBlocked) {
    end(SessionEnd::kSafetyStop, "the board does not arm: a wheel hangs in the air");
  }
  return armed && armed->outcome == CommandOutcome::kAccepted && resets_ == 0;
}

bool RobotSession::configure() {
  const protocol::Configuration& wanted = profile_.configuration;
  const auto& robot = link_.robot();
  if (robot && robot->config_digest == protocol::config_digest(wanted)) {
    spdlog::debug("the board holds the configuration of profile '{}' already", profile_.name);
    return true;
  }
  const auto before = read_configuration();
  for (const robot_link::Command& command : commands_between(before, wanted)) {
    if (!send_configuration(command)) {
      return false;
    }
  }
  const auto after = read_configuration();
  if (!after) {
    return false;
  }
  if (const std::string difference = first_difference(*after, wanted); !difference.empty()) {
    throw CommandError(ExitCode::kConfigInvalid,
                       "the board does not hold what it was sent: " + difference +
                           "\n  next: ./run flash --port " + stream_->name());
  }
  return resets_ == 0;
}

bool RobotSession::send_configuration(const robot_link::Command& command) {
  const auto result = perform(command);
  if (result && result->outcome == CommandOutcome::kOutOfRange) {
    throw CommandError(ExitCode::kConfigInvalid,
                       "the board refuses " + name_of(command) + " of profile '" + profile_.name +
                           "': it has no such pins or sensors, or a number is out of its range\n"
                           "  next: compare the profile with the board's page in docs/hardware, or "
                           "update the firmware: ./run flash --port " +
                           stream_->name());
  }
  return result && result->outcome == CommandOutcome::kAccepted;
}

std::optional<protocol::Configuration> RobotSession::read_configuration() {
  bulk_.reset();
  link_.read(protocol::BulkContent::kConfiguration);
  wait_until([&] { return bulk_.has_value() || resets_ > 0; }, kBulkLimit);
  return bulk_ ? configuration_in(*bulk_) : std::nullopt;
}

MotionResult RobotSession::execute(const exploration::Motion& motion) {
  if (!be_ready()) {
    return MotionResult::kInterrupted;
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
  const double ramp_s =
      2.0 * profile_.ticks_per_s() / profile_.configuration.drive.max_ticks_per_s2;
  const double expected_s = static_cast<double>(longest) / profile_.ticks_per_s() + ramp_s;

  link_.keep_alive(true);
  const MotionResult result = finish(
      protocol::MoveTicks{0, ticks.left, ticks.right, profile_.ticks_per_s(), time_to_live_ms_},
      seconds_of(expected_s));
  wait_until([] { return false; }, kRest);
  link_.keep_alive(false);
  return result;
}

MotionResult RobotSession::sweep(const exploration::Sweep& sweep) {
  const double steps = std::abs((sweep.to_rad - sweep.from_rad) / sweep.step_rad) + 1.0;
  const double step_s = sweep.settle_s + 0.15;
  const protocol::StartSweep command{0,
                                     centidegrees(sweep.from_rad),
                                     centidegrees(sweep.to_rad),
                                     centidegrees(sweep.step_rad),
                                     static_cast<std::uint16_t>(std::lround(sweep.settle_s * 1e3))};
  MotionResult result = MotionResult::kInterrupted;
  for (int i = 0; i < kSweepTries && result == MotionResult::kInterrupted && be_ready(); ++i) {
    result = finish(command, seconds_of(steps * step_s + 1.0));
  }
  return result;
}

/// Sends the command and waits until the robot's Status says that its motion has ended.
MotionResult RobotSession::finish(const robot_link::Command& command, Duration expected) {
  const auto result = perform(command);
  if (!result || result->outcome != CommandOutcome::kAccepted) {
    return result ? refusal_of(result->outcome) : MotionResult::kInterrupted;
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
  return resets_ > 0 ? MotionResult::kInterrupted : result_of(outcome());
}

void RobotSession::end_for_safety(protocol::MotionOutcome outcome) {
  if (const auto why = safety_stop(outcome); !why.empty()) {
    end(SessionEnd::kSafetyStop, "the board has stopped: " + std::string(why));
  }
}

MotionResult RobotSession::result_of(protocol::MotionOutcome outcome) {
  end_for_safety(outcome);
  switch (outcome) {
    case protocol::MotionOutcome::kReached:
      return MotionResult::kReached;
    case protocol::MotionOutcome::kBumped:
      return MotionResult::kBumped;
    case protocol::MotionOutcome::kHazard:
      return MotionResult::kHazard;
    case protocol::MotionOutcome::kStalled:
      return MotionResult::kStalled;
    case protocol::MotionOutcome::kLifted:
      return MotionResult::kLifted;
    case protocol::MotionOutcome::kExpired:
    case protocol::MotionOutcome::kNone:
      return MotionResult::kInterrupted;
    default:
      return MotionResult::kTimedOut;
  }
}

std::optional<robot_link::CommandResult> RobotSession::perform(const robot_link::Command& command) {
  const auto ticket = link_.submit(command);
  const auto done = [&] { return result_ && result_->ticket == ticket; };
  return wait_until(done, seconds(5)) ? result_ : std::nullopt;
}

void RobotSession::disarm() {
  const bool hears = connected_ && link_.state() == LinkState::kReady &&
                     stream_->status() == transport::StreamStatus::kOpen &&
                     pace_->end_reason().empty();
  if (!hears || disarmed_) {
    return;
  }
  disarmed_ = true;
  link_.keep_alive(false);
  const auto ticket = link_.submit(protocol::Arm{0, 0});
  const time::HostTime start = now_;
  const auto done = [&] { return result_ && result_->ticket == ticket; };
  while (!done() && now_ - start < kDisarmLimit) {
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
    end(SessionEnd::kInterrupted, "interrupted");
    return;
  }
  const bool closed = stream_->status() == transport::StreamStatus::kClosed;
  if (closed || !pace_->end_reason().empty()) {
    end(SessionEnd::kLinkLost,
        "lost " + stream_->name() + ": " +
            (closed ? stream_->close_reason() : pace_->end_reason()));
    return;
  }
  if (!connected_ || link_.state() == LinkState::kReady) {
    away_since_.reset();
  } else if (!away_since_) {
    away_since_ = now_;
  } else if (now_ - *away_since_ > patience_) {
    const std::string why = stream_->close_reason();
    end(SessionEnd::kLinkLost,
        "lost " + stream_->name() + ": " + (why.empty() ? "the robot has fallen silent" : why));
  }
}

void RobotSession::end(SessionEnd end, const std::string& reason) {
  if (!end_) {
    end_ = end;
    end_reason_ = reason;
  }
}

void RobotSession::on_odometry(const protocol::Odometry& message) {
  pipeline_.on_odometry(converter_.convert(message));
}

void RobotSession::on_echo(const protocol::Echo& message) {
  pipeline_.on_sonar(converter_.convert(message));
}

void RobotSession::on_status(const protocol::Status& message) {
  status_ = message;
  const auto hazards = converter_.convert(message);
  pipeline_.on_hazards(hazards);
  if (hazards.lifted && connected_) {
    end_for_safety(protocol::MotionOutcome::kLifted);
  }
}

void RobotSession::on_health(const protocol::Health& message) {
  if (const auto battery = converter_.convert(message)) {
    pipeline_.on_battery(*battery);
  }
}

void RobotSession::on_ranges(const protocol::Ranges& message) {
  pipeline_.on_infrared(converter_.convert(message));
}

void RobotSession::on_gyro(const protocol::Gyro& message) {
  if (const auto yaw = converter_.convert(message)) {
    pipeline_.on_yaw(*yaw);
  }
}

void RobotSession::on_ready(const protocol::HelloReply& reply) {
  spdlog::debug("robot ready: firmware {}.{:02}, boot {:04x}",
                reply.firmware_version / 100,
                reply.firmware_version % 100,
                reply.boot_id);
  if (const auto& difference = link_.difference()) {
    spdlog::warn("firmware and host differ, but in nothing that is needed: {}",
                 difference->summary());
  }
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

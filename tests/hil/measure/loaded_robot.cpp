// SPDX-License-Identifier: MIT
#include "tests/hil/measure/loaded_robot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "protocol/limits.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::tests {
namespace {

constexpr double kRightFaster = 1.0027;
constexpr std::uint16_t kEdgesPerS2 = 60'000;
constexpr std::int64_t kTurnsRoundMs = 6'000;
constexpr std::int64_t kSweepMs = 2'500;
/// Wheels rest at the end of each of these, for long enough that a report stands wholly in it.
constexpr std::int64_t kRestPeriodMs = 500;
constexpr std::int64_t kRestMs = 10;
/// Longer than the line takes for a report that nothing stands before.
constexpr std::int64_t kMinDelayUs = 2'000;

}  // namespace

LoadedRobot::LoadedRobot(const std::filesystem::path& elf, const Load& load)
    : load_(load), robot_(elf) {
  robot_.board().on_trigger = [this](std::int64_t at_ns) { answer_ping(at_ns); };
  if (load.every_sensor && EverySensor::knows(robot_.board().board_name())) {
    sensors_.emplace(robot_.board());
  }
}

void LoadedRobot::connect() {
  const protocol::ConfigureDrive drive{
      0, 0, protocol::kMaxTicksPerS, kEdgesPerS2, 2, 3, 3, load_.odometry_period_ms};
  // Wheels that turn to and fro at speed are what the guard is there to stop.
  const protocol::ConfigureSafety no_guard{0, 0, 0, 0, 0};
  const bool ready = robot_.connect() &&
                     robot_.command(drive) == protocol::CommandStatus::kAccepted &&
                     robot_.command(no_guard) == protocol::CommandStatus::kAccepted &&
                     (!sensors_ || sensors_->switch_on(robot_)) &&
                     robot_.command(protocol::Arm{0, 1}) == protocol::CommandStatus::kAccepted;
  if (!ready) {
    throw std::runtime_error("the robot does not get ready");
  }
  robot_.forget_heard();
  bytes_before_ = robot_.bytes().size();
  resets_before_ = robot_.chip().resets();
}

void LoadedRobot::run_s(double seconds) {
  const std::int64_t end_ms = ms_ + std::llround(seconds * 1000.0);
  while (ms_ < end_ms) {
    run_one_ms();
  }
  result_.seconds += seconds;
}

LoadResult LoadedRobot::finish() {
  const double bytes = double(robot_.bytes().size() - bytes_before_);
  result_.host_bytes_per_s = double(host_bytes_) / result_.seconds;
  result_.robot_bytes_per_s = bytes / result_.seconds;
  rest();
  robot_.run_ms(150);  // less than the time to live
  take_heard();
  const auto host = robot_.counters();
  result_.frames_bad = static_cast<std::uint16_t>(result_.frames_bad + host.frames_bad());
  result_.frames_lost = static_cast<std::uint16_t>(result_.frames_lost + host.frames_lost());
  result_.resets = robot_.chip().resets() - resets_before_;
  return result_;
}

void LoadedRobot::run_one_ms() {
  turn_wheels();
  talk();
  robot_.run_ms(1);
  take_heard();
  ++ms_;
}

/// At the full rate to and fro, so that on the whole they are where the robot wants them.
void LoadedRobot::turn_wheels() {
  constexpr double kChangePerMs = kEdgesPerS2 / 1000.0;
  const double fastest = std::min(0.95 * load_.edges_per_s, double(protocol::kMaxTicksPerS));
  const double target = ms_ / kTurnsRoundMs % 2 == 0 ? fastest : -fastest;
  speed_ += std::clamp(target - speed_, -kChangePerMs, kChangePerMs);
  told_ticks_ += speed_ * 1e-3;
  if (ms_ % kRestPeriodMs >= kRestPeriodMs - kRestMs) {
    rest();
    return;
  }
  resting_since_us_.reset();
  const auto towards = [&](TurningWheel& wheel, double ticks, double edges_per_s) {
    const std::int64_t before = wheel.count();
    wheel.turn(double(before) < ticks ? edges_per_s : -edges_per_s, kMs);
    result_.edges += std::abs(wheel.count() - before);
  };
  towards(left_, told_ticks_, load_.edges_per_s);
  towards(right_, -told_ticks_, load_.edges_per_s * kRightFaster);
}

void LoadedRobot::talk() {
  const std::int64_t setpoint_ms = load_.full_line ? 2 : 100;
  const std::int64_t keep_alive_ms = load_.full_line ? 4 : 50;
  if (ms_ % setpoint_ms == 0) {
    const auto told = static_cast<std::int16_t>(speed_);
    send(protocol::DriveSetpoint{told, static_cast<std::int16_t>(-told), 200});
  }
  if (ms_ % keep_alive_ms == 1) {
    send(protocol::KeepAlive{200});
  }
  keep_sweeping();
}

/// To and fro. The last sweep has ended when the next begins: all the time means back to back.
void LoadedRobot::keep_sweeping() {
  const bool due = load_.sweeps_on ? ms_ % 20 == 2 && !sweeping_ : ms_ % kSweepMs == 2;
  if (!due) {
    return;
  }
  sweep_id_ = protocol::next_command_id(sweep_id_);
  sweeping_ = true;
  const bool back = sweep_id_ % 2 == 0;
  send(protocol::StartSweep{sweep_id_,
                            std::int16_t(back ? 3000 : -3000),
                            std::int16_t(back ? -3000 : 3000),
                            std::int16_t(back ? -600 : 600),
                            0});
}

void LoadedRobot::answer_ping(std::int64_t at_ns) {
  const auto below = [this](double span_us) {
    return std::int64_t(generator_() % std::uint32_t(span_us * 1000.0 + 1.0));
  };
  const std::int64_t rise_ns = at_ns + 460'000 + below(1.0);
  const std::int64_t fall_ns = rise_ns + std::llround(load_.min_echo_us * 1000.0) +
                               below(load_.max_echo_us - load_.min_echo_us);
  robot_.board().schedule_echo(rise_ns, fall_ns);
  widths_us_.push_back(double(fall_ns - rise_ns) * 1e-3);
}

/// Compares and drops what has been heard.
void LoadedRobot::take_heard() {
  for (const auto& echo : robot_.all<protocol::Echo>()) {
    const double error_us = std::abs(echo.flight_us - widths_us_.at(0));
    result_.worst_echo_error_us = std::max(result_.worst_echo_error_us, error_us);
    widths_us_.pop_front();
    ++result_.echoes;
  }
  for (const Heard& heard : robot_.heard()) {
    if (const auto* odometry = std::get_if<protocol::Odometry>(&heard.message)) {
      compare(*odometry, heard.at_ns / 1000);
    }
  }
  if (const auto status = robot_.last<protocol::Status>()) {
    sweeping_ = sweeping_ && (status->sweep_id != sweep_id_ ||
                              status->sweep_outcome ==
                                  static_cast<std::uint8_t>(protocol::MotionOutcome::kRunning));
    result_.under_control =
        status->move_outcome == static_cast<std::uint8_t>(protocol::MotionOutcome::kNone);
  }
  if (const auto health = robot_.last<protocol::Health>()) {
    result_.encoder_errors = health->encoder_errors;
    result_.frames_bad = health->frames_bad;
    result_.frames_lost = health->frames_lost;
    result_.receive_overruns = health->receive_overruns;
    if (health->stack_free_bytes != 0) {  // 0: not yet known.
      result_.min_stack_bytes = std::min(result_.min_stack_bytes, health->stack_free_bytes);
    }
  }
  robot_.forget_heard();
}

void LoadedRobot::rest() {
  if (!resting_since_us_) {
    resting_since_us_ = robot_.board().now_ns() / 1000;
  }
}

/// The least delay between stamp and arrival tells the robot's clock, but for that delay itself.
void LoadedRobot::compare(const protocol::Odometry& odometry, std::int64_t heard_us) {
  const std::int64_t stamp_us = odometry.stamp_us;
  min_delay_us_ = std::min(min_delay_us_, heard_us - stamp_us);
  if (!resting_since_us_ || stamp_us + min_delay_us_ < *resting_since_us_ + kMinDelayUs) {
    return;
  }
  const auto difference = [](std::int64_t count, std::int16_t reported) {
    return std::abs(std::int64_t{static_cast<std::int16_t>(count - reported)});
  };
  ++result_.comparisons;
  result_.miscounts = std::max({result_.miscounts,
                                difference(left_.count(), odometry.left_ticks),
                                difference(right_.count(), odometry.right_ticks)});
}

}  // namespace echomap::tests

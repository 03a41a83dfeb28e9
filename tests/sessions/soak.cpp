// SPDX-License-Identifier: MIT
#include "tests/sessions/soak.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <random>
#include <vector>

#include "hil_mock/runner/faulty_board.hpp"
#include "host/robot_link/robot_link.hpp"
#include "tests/hil/turning_wheel.hpp"
#include "tests/support/resident_memory.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::tests {
namespace {

using protocol::MotionOutcome;
using robot_link::CommandOutcome;

constexpr double kNsPerHour = 3.6e12;
constexpr std::int64_t kBootMs = 50;
constexpr std::int64_t kHostStepMs = 1;
/// Of wheels that coast, of all that is on its way, and of a link that shakes hands again.
constexpr std::int64_t kRestMs = 1500;
constexpr std::int64_t kLongestMotionMs = 20'000;
constexpr std::uint8_t kOdometryPeriodMs = 20;
constexpr std::uint64_t kCutEvery = 20;
constexpr std::uint16_t kSessionId = 0x50A4;

runner::LineModel line(std::uint32_t seed) {
  return {
      .faults = {.rates = {.flip = 2e-5, .drop = 1e-5, .insert = 1e-5, .burst = 5e-6, .cut = 5e-6},
                 .loss = 0.002,
                 .seed = seed}};
}

/// A wheel as the host counts it: sums of differences of 16 bits.
class HostCount {
 public:
  void note(std::int16_t ticks) {
    count_ += static_cast<std::int16_t>(ticks - last_);
    last_ = ticks;
  }
  std::int64_t count() const { return count_; }

 private:
  std::int64_t count_ = 0;
  std::int16_t last_ = 0;
};

class Soak : private robot_link::RobotLinkListener {
 public:
  Soak(std::unique_ptr<runner::SimulatedBoard> board, std::uint32_t seed)
      : board_(std::move(board), line(seed)), random_(seed), link_(*this, kSessionId) {
    board_.on_sent = [this](std::uint8_t byte) { to_host_.push_back(byte); };
    board_.on_trigger = [this](std::int64_t at_ns) { answer_ping(at_ns); };
    board_.run_until(kBootMs * kMs);  // what is said while it boots would count as overruns
    expect(perform(protocol::ConfigureDrive{0, 0, 3000, 6000, 20, 30, 300, kOdometryPeriodMs}));
    expect(perform(protocol::Arm{0, 1}));
  }

  void round() {
    ++result_.rounds;
    const bool cut = result_.rounds % kCutEvery == 0;
    result_.cuts += cut ? 1 : 0;
    move(cut);
    rest();
    sweep();
    follow_setpoints();
    rest();
  }

  double hours() const { return double(board_.now_ns()) / kNsPerHour; }

  const SoakResult& result() {
    result_.hours = hours();
    result_.frames_lost = link_.statistics().frames_lost;
    result_.resets = link_.statistics().resets_seen;
    return result_;
  }

 private:
  void on_odometry(const protocol::Odometry& message) override {
    left_host_.note(message.left_ticks);
    right_host_.note(message.right_ticks);
    const time::RobotTime stamp = robot_time_.unwrap(message.stamp_us);
    first_odometry_ = first_odometry_.value_or(stamp);
    last_stamp_us_ = message.stamp_us;
    constexpr std::int64_t kPeriodUs = 1000 * kOdometryPeriodMs;
    const std::int64_t late_us = (stamp - *first_odometry_).count() % kPeriodUs;
    result_.worst_lateness_us =
        std::max(result_.worst_lateness_us, double(std::min(late_us, kPeriodUs - late_us)));
  }

  /// Frames get lost, so pings before this one may have no echo here.
  void on_echo(const protocol::Echo& message) override {
    ++result_.echoes;
    const auto error_us = [&](double width_us) { return std::abs(message.flight_us - width_us); };
    const auto own =
        std::min_element(widths_us_.begin(), widths_us_.end(), [&](double a, double b) {
          return error_us(a) < error_us(b);
        });
    if (own == widths_us_.end()) {
      ++result_.failures;
      return;
    }
    result_.worst_echo_error_us = std::max(result_.worst_echo_error_us, error_us(*own));
    widths_us_.erase(widths_us_.begin(), own + 1);
  }

  void on_status(const protocol::Status& message) override { status_ = message; }

  void on_health(const protocol::Health& message) override {
    result_.encoder_errors = message.encoder_errors;
    result_.receive_overruns = message.receive_overruns;
    if (message.stack_free_bytes != 0) {
      result_.min_stack_bytes = std::min(result_.min_stack_bytes, message.stack_free_bytes);
    }
  }

  void on_command_done(const robot_link::CommandResult& result) override { done_ = result; }

  std::int64_t between(std::int64_t least, std::int64_t most) {
    return least + std::int64_t(random_() % std::uint32_t(most - least + 1));
  }

  void expect(bool good) { result_.failures += good ? 0 : 1; }

  void step() {
    for (std::int64_t i = 0; i < kHostStepMs; ++i) {
      left_.step_ms();
      right_.step_ms();
      const std::int64_t edges =
          std::abs(left_.count() - left_before_) + std::abs(right_.count() - right_before_);
      result_.edges += std::uint64_t(edges);
      left_before_ = left_.count();
      right_before_ = right_.count();
      board_.run_until(board_.now_ns() + kMs);
    }
    const bool dead = board_.now_ns() < dead_until_ns_;
    const time::HostTime now(std::chrono::microseconds(board_.now_ns() / 1000));
    if (!dead) {
      link_.receive(to_host_, now);
    }
    to_host_.clear();
    link_.poll(now);
    const std::vector<std::uint8_t> outgoing = link_.take_outgoing();
    if (!dead) {
      board_.receive(outgoing);
    }
  }

  template <class Done>
  bool wait_until(const Done& done, std::int64_t ms) {
    const std::int64_t end_ns = board_.now_ns() + ms * kMs;
    while (!done() && board_.now_ns() < end_ns) {
      step();
    }
    return done();
  }

  bool perform(const robot_link::Command& command) {
    done_.reset();
    link_.submit(command);
    return wait_until([this] { return done_.has_value(); }, kLongestMotionMs) &&
           done_->outcome == CommandOutcome::kAccepted;
  }

  /// Of the motion that was begun last; kRunning until the robot has told.
  MotionOutcome outcome_of(std::uint8_t protocol::Status::*id,
                           std::uint8_t protocol::Status::*outcome) const {
    const bool told = status_ && done_ && (*status_).*id == done_->command_id;
    return told ? static_cast<MotionOutcome>((*status_).*outcome) : MotionOutcome::kRunning;
  }

  /// Where the line dies the robot must stop by itself, and the host hear of it afterwards. A fault
  /// that eats all that is said in 200 ms stops it, too.
  void move(bool cut) {
    const auto ticks = [this] {
      return std::int32_t(between(1500, 4000) * (random_() % 2 == 0 ? 1 : -1));
    };
    const auto speed = static_cast<std::uint16_t>(between(400, 2500));
    const auto outcome = [this] {
      return outcome_of(&protocol::Status::move_id, &protocol::Status::move_outcome);
    };
    link_.keep_alive(true);
    expect(perform(protocol::MoveTicks{0, ticks(), ticks(), speed, 200}));
    if (cut) {
      dead_until_ns_ = board_.now_ns() + between(900, 3000) * kMs;
    }
    wait_until([&] { return outcome() != MotionOutcome::kRunning; }, kLongestMotionMs);
    link_.keep_alive(false);
    const bool expired = outcome() == MotionOutcome::kExpired;
    result_.expired += expired ? 1 : 0;
    expect(expired || (!cut && outcome() == MotionOutcome::kReached));
  }

  void sweep() {
    const bool back = result_.rounds % 2 == 0;
    const auto from = std::int16_t(back ? 6000 : -6000);
    expect(perform(protocol::StartSweep{0, from, -from, back ? -600 : 600, 0}));
    const auto reached = [this] {
      return outcome_of(&protocol::Status::sweep_id, &protocol::Status::sweep_outcome) ==
             MotionOutcome::kReached;
    };
    expect(wait_until(reached, kLongestMotionMs));
  }

  void follow_setpoints() {
    for (int i = 0; i < 20; ++i) {
      const auto left = static_cast<std::int16_t>(between(-2000, 2000));
      const auto right = static_cast<std::int16_t>(between(-2000, 2000));
      link_.send(protocol::DriveSetpoint{left, right, 300},
                 time::HostTime(std::chrono::microseconds(board_.now_ns() / 1000)));
      wait_until([] { return false; }, 100);
    }
    expect(perform(protocol::Stop{0}));
  }

  void rest() {
    wait_until([] { return false; }, kRestMs);
    result_.worst_drift_ticks = std::max({result_.worst_drift_ticks,
                                          std::abs(left_.count() - left_host_.count()),
                                          std::abs(right_.count() - right_host_.count())});
    // Emulated, the robot's clock is that of the world but for the moment of its start.
    const auto clock = link_.clock().host_time(last_stamp_us_);
    const auto robot_us = double(robot_time_.last().time_since_epoch().count());
    if (!clock) {
      expect(false);
      return;
    }
    const double offset_us = double(std::chrono::duration_cast<std::chrono::microseconds>(
                                        clock->instant.time_since_epoch())
                                        .count()) -
                             robot_us;
    first_offset_us_ = first_offset_us_.value_or(offset_us);
    result_.worst_clock_error_us =
        std::max(result_.worst_clock_error_us, std::abs(offset_us - *first_offset_us_));
  }

  void answer_ping(std::int64_t at_ns) {
    const std::int64_t width_us = between(300, 23'000);
    board_.schedule_echo(at_ns + 460'000, at_ns + 460'000 + width_us * 1000);
    widths_us_.push_back(double(width_us));
  }

  runner::FaultyBoard board_;
  std::mt19937 random_;
  DrivenWheel left_{board_, runner::Wheel::kLeft};
  DrivenWheel right_{board_, runner::Wheel::kRight};
  robot_link::RobotLink link_;
  std::vector<std::uint8_t> to_host_;
  std::int64_t dead_until_ns_ = 0;
  std::int64_t left_before_ = 0;
  std::int64_t right_before_ = 0;

  HostCount left_host_;
  HostCount right_host_;
  time::RobotTimeUnwrapper robot_time_;
  std::uint32_t last_stamp_us_ = 0;
  std::optional<time::RobotTime> first_odometry_;
  std::optional<double> first_offset_us_;
  std::deque<double> widths_us_;
  std::optional<protocol::Status> status_;
  std::optional<robot_link::CommandResult> done_;
  SoakResult result_;
};

}  // namespace

bool SoakResult::holds() const {
  return failures == 0 && worst_drift_ticks == 0 && worst_echo_error_us <= 1.0 &&
         worst_lateness_us <= 1000.0 && worst_clock_error_us <= 1000.0 && resets == 0 &&
         encoder_errors == 0 && receive_overruns == 0 && grown_mb <= 8.0;
}

SoakResult soak(std::unique_ptr<runner::SimulatedBoard> board,
                double hours,
                std::uint32_t seed,
                const std::function<void(const SoakResult&)>& progress) {
  Soak soak(std::move(board), seed);
  std::optional<double> early_mb;
  double grown_mb = 0.0;
  for (int tenth = 1; tenth <= 10; ++tenth) {
    while (soak.hours() < hours * tenth / 10.0) {
      soak.round();
    }
    early_mb = early_mb.value_or(resident_mb());
    grown_mb = std::max(grown_mb, resident_mb() - *early_mb);
    if (progress) {
      SoakResult now = soak.result();
      now.grown_mb = grown_mb;
      progress(now);
    }
  }
  SoakResult result = soak.result();
  result.grown_mb = grown_mb;
  return result;
}

}  // namespace echomap::tests

// SPDX-License-Identifier: MIT
#include "host/session/robot_line.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "host/console/interrupt.hpp"
#include "host/robot_link/reset_cause.hpp"
#include "host/session/connect_failure.hpp"
#include "host/session/firmware_name.hpp"

namespace echomap::session {
namespace {

using robot_link::LinkState;
using std::chrono::seconds;

/// For a command, with those before it and all resends.
constexpr seconds kCommandLimit(5);
/// For a command under way and the disarming behind it, with resends.
constexpr seconds kDisarmLimit(1);
/// For the whole of a configuration, with resends.
constexpr seconds kBulkLimit(5);
/// For whoever has lifted the robot to put it down again.
constexpr std::chrono::minutes kLongestLift(5);
/// An absence that is no mere reset.
constexpr std::chrono::milliseconds kWorthTelling(500);

double seconds_of(RobotLine::Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

RobotLine::RobotLine(RobotConnection robot,
                     const RobotProfile& profile,
                     pipeline::ObservationSink& sink)
    : stream_(std::move(robot.stream)),
      pace_(std::move(robot.pace)),
      patience_(robot.patience),
      may_be_lifted_(robot.may_be_lifted),
      reset_loses_pan_(profile.has_sonar &&
                       profile.configuration.pan.kind ==
                           static_cast<std::uint8_t>(protocol::PanKind::kStepper)),
      time_to_live_ms_(static_cast<std::uint16_t>(
          std::chrono::duration_cast<std::chrono::milliseconds>(robot.link.keep_alive_ttl)
              .count())),
      observations_(profile, sink),
      link_(*this, robot.session_id, robot.link),
      recorder_(robot.recorder) {}

void RobotLine::begin() {
  step();
  look_for_end();
}

bool RobotLine::wait_until(const std::function<bool()>& done, Duration limit) {
  const time::HostTime start = now_;
  while (!end_ && !done() && now_ - start < limit) {
    step();
    look_for_end();
  }
  return done();
}

bool RobotLine::wait_until_ready() {
  const auto ready = [&] {
    return link_.state() == LinkState::kReady && !(may_be_lifted_ && is_lifted_);
  };
  return wait_until(ready, Duration::max()) && !end_;
}

std::optional<robot_link::CommandResult> RobotLine::perform(const robot_link::Command& command) {
  const auto ticket = link_.submit(command);
  const auto done = [&] { return result_ && result_->ticket == ticket; };
  return wait_until(done, kCommandLimit) ? result_ : std::nullopt;
}

void RobotLine::drive(const sensors::WheelTicks& ticks_per_s) {
  const auto within = [](std::int32_t ticks) {
    constexpr std::int32_t kMost = std::numeric_limits<std::int16_t>::max();
    return static_cast<std::int16_t>(std::clamp(ticks, -kMost, kMost));
  };
  link_.send(
      protocol::DriveSetpoint{
          within(ticks_per_s.left), within(ticks_per_s.right), time_to_live_ms_},
      now_);
}

std::optional<robot_link::BulkResult> RobotLine::read(protocol::BulkContent content) {
  bulk_.reset();
  link_.read(content);
  wait_until([&] { return bulk_.has_value() || was_reset_; }, kBulkLimit);
  return bulk_;
}

void RobotLine::disarm() {
  const bool hears = is_held_ && link_.state() == LinkState::kReady;
  if (!hears || !goes_on() || disarmed_) {
    return;
  }
  disarmed_ = true;
  was_reset_ = true;
  link_.keep_alive(false);
  const auto ticket = link_.submit(protocol::Arm{0, 0});
  const time::HostTime start = now_;
  const auto done = [&] { return result_ && result_->ticket == ticket; };
  while (!done() && goes_on() && now_ - start < kDisarmLimit) {
    step();
  }
}

bool RobotLine::goes_on() const {
  return stream_->status() == transport::StreamStatus::kOpen && pace_->end_reason().empty();
}

void RobotLine::step() {
  const auto outgoing = link_.take_outgoing();
  stream_->write(outgoing);
  bytes_sent_ += outgoing.size();
  recorder_.sent(outgoing);
  std::vector<std::uint8_t> received;
  now_ = pace_->step(*stream_, bytes_sent_, [&](std::span<const std::uint8_t> bytes) {
    received.insert(received.end(), bytes.begin(), bytes.end());
  });
  recorder_.set_time(now_);
  recorder_.receive(received,
                    [this](std::span<const std::uint8_t> frame) { link_.receive(frame, now_); });
  link_.poll(now_);
  if (on_step) {
    on_step();
  }
}

void RobotLine::look_for_end() {
  if (console::interrupted()) {
    end(SessionEnd::kInterrupted, "interrupted");
    return;
  }
  const bool closed = stream_->status() == transport::StreamStatus::kClosed;
  if (closed || !pace_->end_reason().empty()) {
    end(SessionEnd::kLinkLost,
        "lost " + name() + ": " + (closed ? stream_->close_reason() : pace_->end_reason()) +
            "\n  next: check the cable or the simulated robot, then start again");
    return;
  }
  if (is_held_ && link_.state() == LinkState::kMismatch) {
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): in this state it has one
    end(SessionEnd::kFirmwareMismatch, link_.mismatch()->message());
    return;
  }
  if (is_held_ && link_.state() == LinkState::kBusy) {
    end(SessionEnd::kTakenOver, reason_of_take_over(link_, name()));
    return;
  }
  look_for_absence();
  look_for_lift();
}

void RobotLine::look_for_lift() {
  if (!is_lifted_ || !is_held_ || !may_be_lifted_) {
    lifted_since_.reset();
  } else if (!lifted_since_) {
    lifted_since_ = now_;
    spdlog::info("the robot is off the floor; waiting up to {} minutes for it to be put down",
                 kLongestLift.count());
  } else if (now_ - *lifted_since_ > kLongestLift) {
    end(SessionEnd::kSafetyStop,
        fmt::format("the robot was lifted and not put down within {} minutes\n"
                    "  next: put it down and start again",
                    kLongestLift.count()));
  }
}

void RobotLine::look_for_absence() {
  if (!is_held_ || link_.state() == LinkState::kReady) {
    if (std::exchange(absence_is_told_, false)) {
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): set when the absence began
      spdlog::info("{} reconnected after {:.1f} s", name(), seconds_of(now_ - *away_since_));
    }
    away_since_.reset();
  } else if (!away_since_) {
    away_since_ = now_;
  } else if (now_ - *away_since_ > patience_) {
    end(SessionEnd::kLinkLost,
        "lost " + name() + ": " + reason_of_absence() +
            "\n  next: check its cable and its supply, then start again; --reconnect 60 waits "
            "longer");
  } else if (now_ - *away_since_ > kWorthTelling && !std::exchange(absence_is_told_, true)) {
    spdlog::warn("{} is disconnected: {}; waiting up to {:.0f} s",
                 name(),
                 reason_of_absence(),
                 seconds_of(patience_));
  }
}

std::string RobotLine::reason_of_absence() const {
  const std::string why = stream_->close_reason();
  return why.empty() ? "the robot stopped sending" : why;
}

void RobotLine::end(SessionEnd end, const std::string& reason) {
  if (!end_) {
    end_ = end;
    end_reason_ = reason;
  }
}

void RobotLine::end_for_safety(protocol::MotionOutcome outcome) {
  if (may_be_lifted_ && outcome == protocol::MotionOutcome::kLifted) {
    was_reset_ = true;
    return;
  }
  if (const auto why = safety_stop(outcome); !why.empty()) {
    end(SessionEnd::kSafetyStop, "the board has stopped: " + std::string(why));
  }
}

void RobotLine::on_odometry(const protocol::Odometry& message) {
  odometry_stamp_us_ = message.stamp_us;
  odometry_at_ = now_;
  observe(message);
}

void RobotLine::on_status(const protocol::Status& message) {
  status_ = message;
  observe(message);
  is_lifted_ = hazards().lifted;
  if (is_lifted_ && is_held_) {
    end_for_safety(protocol::MotionOutcome::kLifted);
  }
}

void RobotLine::on_health(const protocol::Health& message) {
  observe(message);
  recorder_.record(link_.statistics());
}

void RobotLine::on_ready(const protocol::HelloReply& reply) {
  spdlog::debug("robot ready: {}, boot {:04x}", firmware_of(reply), reply.boot_id);
  recorder_.record({recording::SessionEventKind::kLinkReady, reply.protocol_minor, {}});
  observations_.set_protocol_minor(reply.protocol_minor);
  if (const auto& difference = link_.difference()) {
    spdlog::warn("firmware and host differ, but only in messages that are not needed: {}",
                 difference->summary());
  }
}

std::optional<protocol::Status> RobotLine::status_since_answer() const {
  return status_ && status_->stamp_us != status_at_answer_us_ ? status_ : std::nullopt;
}

void RobotLine::on_command_done(const robot_link::CommandResult& result) {
  result_ = result;
  status_at_answer_us_ = status_ ? std::optional(status_->stamp_us) : std::nullopt;
  was_reset_ = was_reset_ || result.outcome == robot_link::CommandOutcome::kDisarmed;
}

void RobotLine::on_reset(std::uint8_t reset_cause) {
  if (reset_loses_pan_ && is_held_) {
    end(SessionEnd::kSafetyStop,
        fmt::format("the robot was reset ({}) and its stepper lost the direction of the sonar\n"
                    "  next: turn the sonar straight ahead, then start again",
                    robot_link::reset_cause_text(reset_cause)));
    return;
  }
  spdlog::warn("the robot was reset ({}); keeping the pose and configuring it again",
               robot_link::reset_cause_text(reset_cause));
  const auto passed = std::chrono::duration_cast<time::RobotClock::duration>(now_ - odometry_at_);
  recorder_.record({recording::SessionEventKind::kRobotReset, passed.count(), {}});
  observations_.restart(passed);
  status_.reset();
  odometry_stamp_us_.reset();
  is_lifted_ = false;
  was_reset_ = true;
}

}  // namespace echomap::session

// SPDX-License-Identifier: MIT
#include "firmware/tasks/telemetry.hpp"

#include "firmware/hal/clock.hpp"
#include "firmware/hal/stack.hpp"

namespace echomap {
namespace tasks {
namespace {

uint8_t bit_if(bool condition, protocol::RobotFlags bit) {
  return condition ? static_cast<uint8_t>(bit) : uint8_t{0};
}

}  // namespace

void Telemetry::begin() {
  on_ = true;
  status_waits_ = true;
  health_waits_ = true;
}

void Telemetry::add(const protocol::Echo& echo) {
  if (waiting_echoes_ == kEchoes) {
    oldest_echo_ = static_cast<uint8_t>((oldest_echo_ + 1) % kEchoes);
    --waiting_echoes_;
    ++dropped_;
  }
  echoes_[(oldest_echo_ + waiting_echoes_) % kEchoes] = echo;
  ++waiting_echoes_;
}

void Telemetry::tick() {
  stack_free_bytes_ = hal::least_free_stack_bytes();
  if (!on_) {
    return;
  }
  if (++odometry_age_ms_ >= sources_.configuration.drive.odometry_period_ms) {
    odometry_age_ms_ = 0;
    sample_odometry();
  }
  if (++status_age_ms_ >= kStatusPeriodMs) {
    status_age_ms_ = 0;
    status_waits_ = true;
    count_status();
  }
  notice_outcomes();
  send_what_waits();
}

void Telemetry::count_status() {
  if (++status_since_health_ == kStatusPerHealth) {
    status_since_health_ = 0;
    health_waits_ = true;
  }
}

void Telemetry::sample_odometry() {
  if (odometry_waits_) {
    ++dropped_;
  }
  const drivers::WheelCounts counts = sources_.encoders.counts();
  odometry_ = protocol::Odometry{hal::now_us(), counts.left, counts.right, flags()};
  odometry_waits_ = true;
}

void Telemetry::notice_outcomes() {
  const control::MotionReport move = sources_.motion.report();
  const control::MotionReport sweep = sources_.sweep.report();
  if (move != told_move_ || sweep != told_sweep_) {
    told_move_ = move;
    told_sweep_ = sweep;
    status_waits_ = true;
  }
}

void Telemetry::send_what_waits() {
  while (waiting_echoes_ != 0) {
    if (!send_echo()) {
      return;
    }
  }
  if (status_waits_ && !sender_.tell(status())) {
    return;  // Else odometry, being smaller, would take the room again and again.
  }
  status_waits_ = false;
  if (health_waits_ && !sender_.tell(health())) {
    return;
  }
  health_waits_ = false;
  if (odometry_waits_ && sender_.tell(odometry_)) {
    odometry_waits_ = false;
  }
}

bool Telemetry::send_echo() {
  if (!sender_.tell(echoes_[oldest_echo_])) {
    return false;
  }
  oldest_echo_ = static_cast<uint8_t>((oldest_echo_ + 1) % kEchoes);
  --waiting_echoes_;
  return true;
}

protocol::Status Telemetry::status() const {
  protocol::Status status{};
  status.stamp_us = hal::now_us();
  status.flags = flags();
  status.move_id = told_move_.id;
  status.move_outcome = static_cast<uint8_t>(told_move_.outcome);
  status.sweep_id = told_sweep_.id;
  status.sweep_outcome = static_cast<uint8_t>(told_sweep_.outcome);
  return status;
}

protocol::Health Telemetry::health() const {
  protocol::Health health{};
  health.stamp_us = hal::now_us();
  health.frames_bad = sources_.received.frames_bad();
  health.frames_lost = sources_.received.frames_lost();
  health.receive_overruns = sources_.port.overruns();
  health.telemetry_dropped = dropped_;
  health.encoder_errors = sources_.encoders.errors();
  health.stack_free_bytes = stack_free_bytes_;
  return health;
}

uint8_t Telemetry::flags() const {
  const drivers::Contacts& contacts = sources_.safety.contacts();
  uint8_t flags = 0;
  flags |= bit_if(sources_.safety.armed(), protocol::kFlagArmed);
  flags |= bit_if(sources_.motion.moving(), protocol::kFlagMoving);
  flags |= bit_if(sources_.sweep.sweeping(), protocol::kFlagSweeping);
  flags |= bit_if(contacts.left(), protocol::kFlagBumpLeft);
  flags |= bit_if(contacts.right(), protocol::kFlagBumpRight);
  return flags;
}

}  // namespace tasks
}  // namespace echomap

// SPDX-License-Identifier: MIT
#include "firmware/tasks/telemetry.hpp"

#include "firmware/hal/clock.hpp"
#include "firmware/hal/encoders.hpp"
#include "firmware/hal/stack.hpp"

namespace echomap {
namespace tasks {
namespace {

constexpr uint8_t kContactBit = uint8_t{protocol::kFlagBumpLeft} / uint8_t{hal::kContactLeft};

uint8_t bit_if(bool condition, protocol::RobotFlags bit) {
  return condition ? static_cast<uint8_t>(bit) : uint8_t{0};
}

}  // namespace

void Telemetry::begin() {
  on_ = true;
  status_is_urgent_ = true;
  statuses_since_health_ = kStatusPerHealth;
}

void Telemetry::add(const protocol::Echo& echo) {
  if (waiting_echoes_ == kEchoes) {
    oldest_echo_ = static_cast<uint8_t>((oldest_echo_ + 1) % kEchoes);
    --waiting_echoes_;
    drop();
  }
  echoes_[(oldest_echo_ + waiting_echoes_) % kEchoes] = echo;
  ++waiting_echoes_;
}

void Telemetry::tick() {
  stack_free_bytes_ = hal::min_free_stack_bytes();
  if (!on_) {
    return;
  }
  sender_.budget().tick();
  if (++odometry_age_ms_ >= stretched(sources_.configuration.drive.odometry_period_ms)) {
    odometry_age_ms_ = 0;
    sample_odometry();
  }
  count(sources_.configuration.sensors.ranges_period_ms, ranges_age_ms_, ranges_wait_);
  count(sources_.configuration.scalar.period_ms, scalar_age_ms_, scalar_waits_);
  if (++status_age_ms_ >= stretched(kStatusPeriodMs)) {
    status_age_ms_ = 0;
    status_waits_ = true;
  }
  notice_changes();
  send_what_waits();
}

uint16_t Telemetry::stretched(uint16_t period_ms) const {
  return static_cast<uint16_t>(period_ms << sender_.budget().rate_step());
}

void Telemetry::drop() {
  ++dropped_;
  sender_.budget().overloaded();
}

void Telemetry::count(uint16_t period_ms, uint16_t& age_ms, bool& waits) {
  if (period_ms == 0 || ++age_ms < stretched(period_ms)) {
    return;
  }
  age_ms = 0;
  if (waits) {
    drop();
  }
  waits = true;
}

void Telemetry::sample_odometry() {
  if (gyro_waits_) {
    drop();
  }
  if (odometry_waits_) {
    drop();
  }
  const drivers::WheelCounts counts = sources_.encoders.counts();
  odometry_ = protocol::Odometry{hal::encoders_read_at_us(), counts.left, counts.right, flags()};
  odometry_waits_ = true;
  gyro_waits_ = sources_.configuration.sensors.gyro_period_ms != 0;
}

void Telemetry::notice_changes() {
  const control::MotionReport move = sources_.motion.report();
  const control::MotionReport sweep = sources_.sweep.report();
  const uint8_t hazards = sources_.sensors.hazards().active();
  if (move != told_move_ || sweep != told_sweep_ || hazards != told_hazards_) {
    told_hazards_ = hazards;
    told_move_ = move;
    told_sweep_ = sweep;
    status_is_urgent_ = true;
  }
}

void Telemetry::send_what_waits() {
  while (waiting_echoes_ != 0) {
    if (!send_echo()) {
      return;
    }
  }
  // Nothing overtakes what waits: the smaller would take the room again and again.
  if (status_is_urgent_ && !send_status()) {
    return;
  }
  if (odometry_waits_ && !sender_.tell(odometry_)) {
    return;
  }
  odometry_waits_ = false;
  if (gyro_waits_ && !sender_.tell(gyro())) {
    return;
  }
  gyro_waits_ = false;
  if (ranges_wait_ && !sender_.tell(ranges())) {
    return;
  }
  ranges_wait_ = false;
  if (scalar_waits_ && !sender_.tell(scalar())) {
    return;
  }
  scalar_waits_ = false;
  if (status_waits_ && statuses_since_health_ != kStatusPerHealth) {
    send_status();
  }
  if (statuses_since_health_ == kStatusPerHealth) {
    send_health();
  }
  if (encoder_errors_wait_ && sender_.tell(encoder_errors())) {
    encoder_errors_wait_ = false;
  }
}

bool Telemetry::send_status() {
  if (!sender_.tell(status())) {
    return false;
  }
  status_waits_ = false;
  status_is_urgent_ = false;
  if (statuses_since_health_ != kStatusPerHealth) {
    ++statuses_since_health_;
  }
  return true;
}

void Telemetry::send_health() {
  if (sender_.tell(health())) {
    statuses_since_health_ = 0;
    const hal::LostSteps errors = hal::lost_encoder_steps();
    encoder_errors_wait_ = (errors.left | errors.right) != 0;
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
  status.hazards = told_hazards_;
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
  const hal::LostSteps errors = hal::lost_encoder_steps();
  health.encoder_errors = static_cast<uint16_t>(errors.left + errors.right);
  health.stack_free_bytes = stack_free_bytes_;
  health.rate_step = sender_.budget().rate_step();
  health.battery_raw = sources_.sensors.analog().battery();
  return health;
}

protocol::EncoderErrors Telemetry::encoder_errors() const {
  const hal::LostSteps errors = hal::lost_encoder_steps();
  return protocol::EncoderErrors{hal::now_us(), errors.left, errors.right};
}

protocol::Ranges Telemetry::ranges() const {
  const drivers::WheelCounts counts = sources_.encoders.counts();
  const drivers::AnalogInputs& analog = sources_.sensors.analog();
  return protocol::Ranges{hal::encoders_read_at_us(),
                          counts.left,
                          counts.right,
                          analog.range(0),
                          analog.range(1),
                          analog.range(2),
                          analog.range(3),
                          analog.range(4),
                          analog.range(5),
                          analog.range(6),
                          analog.range(7)};
}

protocol::Gyro Telemetry::gyro() const {
  const drivers::Gyro& gyro = sources_.sensors.gyro();
  return protocol::Gyro{hal::now_us(), gyro.yaw_sum(), gyro.samples(), gyro.errors()};
}

protocol::Scalar Telemetry::scalar() const {
  const drivers::WheelCounts counts = sources_.encoders.counts();
  const drivers::ScalarSensor& sensor = sources_.sensors.scalar();
  return protocol::Scalar{
      hal::encoders_read_at_us(), counts.left, counts.right, sensor.sum(), sensor.samples()};
}

uint8_t Telemetry::flags() const {
  static_assert(hal::kContactLeft * kContactBit == protocol::kFlagBumpLeft &&
                    hal::kContactRight * kContactBit == protocol::kFlagBumpRight,
                "contacts go over the wire in their order");
  uint8_t flags = static_cast<uint8_t>(sources_.safety.contacts().pressed() * kContactBit);
  flags |= bit_if(sources_.safety.armed(), protocol::kFlagArmed);
  flags |= bit_if(sources_.motion.moving(), protocol::kFlagMoving);
  flags |= bit_if(sources_.sweep.sweeping(), protocol::kFlagSweeping);
  flags |= bit_if(sources_.safety.stopping_hazards() != 0, protocol::kFlagHazard);
  return flags;
}

}  // namespace tasks
}  // namespace echomap

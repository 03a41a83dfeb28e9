// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/ev3_board.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "protocol/version.hpp"

namespace echomap::ev3 {
namespace {

constexpr std::int64_t kMsNs = 1'000'000;
constexpr std::int64_t kUsNs = 1'000;
constexpr double kMsS = 1e-3;
/// lego-linux-drivers reads the encoders 500 times a second.
constexpr std::int64_t kPositionPeriodNs = 2 * kMsNs;
/// Assumed: the messages of LEGO 45505 come about so fast.
constexpr std::int64_t kGyroPeriodNs = 5 * kMsNs;
constexpr double kMaxGyroDegPerS = 440.0;
constexpr std::int64_t kBootNs = 300 * kMsNs;
constexpr double kSpeedOfSoundMPerS = 343.2;
/// As a real one's pulse width modulation, about: it only has to be faster than the motor.
constexpr double kPwmPeriodUs = 100.0;
constexpr double kCentreUs = 1500.0;
constexpr std::chrono::seconds kStartLimit{20};

/// Of an MPU-6050.
constexpr std::uint8_t kGyroConfig = 0x1B;
constexpr std::uint8_t kRange1000 = 0x10;
constexpr double kCountsPerDegPerS = 32.8;
constexpr std::uint8_t kGyroZoutH = 0x47;
constexpr std::uint8_t kPowerManagement = 0x6B;

/// Where a pair of levels stands in the order 00, 10, 11, 01 of going forward.
unsigned phase_of(bool a, bool b) {
  if (a) {
    return b ? 2U : 1U;
  }
  return b ? 3U : 0U;
}

std::filesystem::path motor_folder(const OwnFolder& folder, int number) {
  return folder.path() / "sys/class/tacho-motor" / ("motor" + std::to_string(number));
}

std::filesystem::path sensor_folder(const OwnFolder& folder, int number) {
  return folder.path() / "sys/class/lego-sensor" / ("sensor" + std::to_string(number));
}

}  // namespace

std::vector<std::string> under_qemu(const std::filesystem::path& elf) {
  return {"qemu-arm", "-cpu", "arm926", elf.string()};
}

// Numbers out of order: on a brick they only say what was found first.
Ev3Board::Ev3Board(Ev3Options options)
    : options_(std::move(options)),
      clock_(folder_.path() / "clock"),
      pan_motor_(motor_folder(folder_, 3), "ev3-ports:outA", medium_motor()),
      left_motor_(motor_folder(folder_, 5), "ev3-ports:outB", large_motor()),
      right_motor_(motor_folder(folder_, 0), "ev3-ports:outC", large_motor()),
      left_touch_(sensor_folder(folder_, 4), "ev3-ports:in1", {"lego-ev3-touch", "TOUCH", 0}),
      right_touch_(sensor_folder(folder_, 1), "ev3-ports:in2", {"lego-ev3-touch", "TOUCH", 0}),
      gyro_(sensor_folder(folder_, 7), "ev3-ports:in3", {"lego-ev3-gyro", "GYRO-ANG", 0}),
      range_facts_(facts_of(options_.range_sensor)),
      range_(sensor_folder(folder_, 2), "ev3-ports:in4", range_facts_.kind) {
  range_.show(range_facts_.nothing);
  start_program();
}

Ev3Board::~Ev3Board() = default;

void Ev3Board::start_program() {
  connections_before_ = clock_.connections();
  std::vector<std::string> command = options_.command;
  command.insert(command.end(),
                 {"--sysfs",
                  sysfs().string(),
                  "--clock",
                  "unix:" + (folder_.path() / "clock").string(),
                  "--line",
                  "stdio"});
  program_ = std::make_unique<FirmwareProcess>(command);
  const auto end = std::chrono::steady_clock::now() + kStartLimit;
  while (clock_.connections() == connections_before_) {
    if (const auto status = program_->exit_status()) {
      throw std::runtime_error(program_name() + " has ended with " + std::to_string(*status));
    }
    if (std::chrono::steady_clock::now() > end) {
      throw std::runtime_error(program_name() + " does not ask for the time");
    }
    clock_.wait_for_connection(static_cast<std::uint64_t>(now_ns_ / kUsNs));
  }
  let_program_run();
}

void Ev3Board::run_until(std::int64_t until_ns) {
  while (now_ns_ < until_ns) {
    step_to(std::min(until_ns, next_event_ns()));
  }
}

std::int64_t Ev3Board::next_event_ns() const {
  const std::int64_t next_ms_ns = (now_ns_ / kMsNs + 1) * kMsNs;
  const auto wake_us = clock_.next_wake_us();
  if (!wake_us) {
    return next_ms_ns;
  }
  // A time beyond any run is as good as never.
  const auto wake_ns = static_cast<std::int64_t>(
      std::min<std::uint64_t>(*wake_us, static_cast<std::uint64_t>(next_ms_ns / kUsNs)) *
      std::uint64_t{kUsNs});
  return std::clamp(wake_ns, now_ns_ + kUsNs, next_ms_ns);
}

void Ev3Board::step_to(std::int64_t to_ns) {
  const bool is_frame = to_ns % kMsNs == 0;
  now_ns_ = to_ns;
  if (is_frame) {
    pan_motor_.turn_freely(kMsS);
    deliver_bytes();
  }
  if (now_ns_ % kPositionPeriodNs == 0) {
    show_positions();
  }
  show_range();
  if (gyro_chip_ != nullptr && now_ns_ % kGyroPeriodNs == 0) {
    show_gyro();
  }
  if (!program_) {
    if (now_ns_ >= starts_ns_) {
      start_program();
    }
    return;
  }
  const bool has_bytes = is_frame && !to_program_.empty();
  if (has_bytes) {
    program_->write(to_program_);
    to_program_.clear();
  }
  const auto wake_us = clock_.next_wake_us();
  const auto now_us = static_cast<std::uint64_t>(now_ns_ / kUsNs);
  if (has_bytes || (wake_us && *wake_us <= now_us) || is_frame) {
    clock_.wake(now_us, has_bytes);
    let_program_run();
  }
}

void Ev3Board::let_program_run() {
  clock_.wait_until_all_sleep(static_cast<std::uint64_t>(now_ns_ / kUsNs),
                              options_.busy_limit,
                              [this] { program_->read(from_program_); });
  program_->read(from_program_);
  obey_files();
}

void Ev3Board::obey_files() {
  pan_motor_.obey();
  left_motor_.obey();
  right_motor_.obey();
  if (on_duty) {
    on_duty();
  }
}

/// With the frames of USB, a millisecond each.
void Ev3Board::deliver_bytes() {
  sent_.swap(from_program_);
  for (const std::uint8_t byte : sent_) {
    if (on_sent) {
      on_sent(byte);
    }
  }
  sent_.clear();
}

void Ev3Board::show_positions() {
  for (Wheel* const wheel : {&left_, &right_}) {
    while (!wheel->edges.empty() && wheel->edges.front().at_ns <= now_ns_) {
      const unsigned steps = (wheel->edges.front().phase - wheel->phase) & 3U;
      wheel->counts += steps == 3U ? -1 : static_cast<int>(steps % 2U);
      wheel->phase = wheel->edges.front().phase;
      wheel->edges.pop_front();
    }
  }
  left_motor_.show_position(left_.counts);
  right_motor_.show_position(right_.counts);
  pan_motor_.show_position(std::llround(pan_motor_.free_shaft_deg()));
}

void Ev3Board::show_range() {
  if (echo_ && echo_->at_ns <= now_ns_) {
    range_.show(range_facts_.told(echo_->range_m));
    echo_.reset();
  }
  if (now_ns_ % range_facts_.period_ns == 0 && on_trigger) {
    on_trigger(now_ns_);
  }
}

/// Clockwise is positive, in whole degrees.
void Ev3Board::show_gyro() {
  const unsigned high = gyro_chip_->read(kGyroZoutH);
  const unsigned low = gyro_chip_->read(kGyroZoutH + 1);
  const auto raw = static_cast<std::int16_t>(high << 8U | low);
  const double rate_deg_per_s =
      std::clamp(-raw / kCountsPerDegPerS, -kMaxGyroDegPerS, kMaxGyroDegPerS);
  turned_deg_ += rate_deg_per_s * static_cast<double>(kGyroPeriodNs) * 1e-9;
  gyro_.show(std::lround(gyro_.mode() == "GYRO-RATE" ? rate_deg_per_s : turned_deg_));
}

void Ev3Board::reset() {
  program_.reset();
  clock_.disconnect_all();
  to_program_.clear();
  from_program_.clear();
  for (TachoMotor* const motor : {&pan_motor_, &left_motor_, &right_motor_}) {
    motor->reset();
  }
  starts_ns_ = now_ns_ + kBootNs;
  if (on_duty) {
    on_duty();
  }
}

void Ev3Board::receive(std::span<const std::uint8_t> bytes) {
  to_program_.insert(to_program_.end(), bytes.begin(), bytes.end());
}

world::DriverInputs Ev3Board::driver_inputs(runner::Wheel wheel,
                                            world::DriverInterface interface) const {
  const TachoMotor& motor = wheel == runner::Wheel::kLeft ? left_motor_ : right_motor_;
  return world::inputs_for(interface, motor.duty(), motor.brakes(), kPwmPeriodUs);
}

double Ev3Board::pan_pulse_us() const { return kCentreUs + pan_motor_.free_shaft_deg(); }

Ev3Board::Wheel& Ev3Board::wheel_of(runner::Wheel wheel) {
  return wheel == runner::Wheel::kLeft ? left_ : right_;
}

void Ev3Board::schedule_encoder_edge(runner::Wheel wheel, std::int64_t at_ns, bool a, bool b) {
  wheel_of(wheel).edges.push_back({at_ns, phase_of(a, b)});
}

void Ev3Board::schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) {
  echo_ = Echo{fall_ns, 0.5 * kSpeedOfSoundMPerS * 1e-9 * static_cast<double>(fall_ns - rise_ns)};
}

void Ev3Board::set_bump(runner::Wheel side, bool closed) {
  (side == runner::Wheel::kLeft ? left_touch_ : right_touch_).show(closed ? 1 : 0);
}

void Ev3Board::set_aux_level(unsigned pin, bool /*high*/) {
  throw std::invalid_argument("ev3 has no spare pin_" + std::to_string(pin));
}

void Ev3Board::schedule_aux_pulse(unsigned pin,
                                  std::int64_t /*fall_ns*/,
                                  std::int64_t /*rise_ns*/) {
  throw std::invalid_argument("ev3 has no spare pin_" + std::to_string(pin));
}

void Ev3Board::set_aux_millivolts(unsigned pin, double /*millivolts*/) {
  throw std::invalid_argument("ev3 has no spare pin_" + std::to_string(pin));
}

bool Ev3Board::aux_output(unsigned /*pin*/) const { return false; }

void Ev3Board::connect(world::TwoWireDevice& device) {
  gyro_chip_ = &device;
  device.write(kPowerManagement, 0);
  device.write(kGyroConfig, kRange1000);
}

std::string Ev3Board::firmware_name() const {
  return program_name() + ' ' + protocol::VersionText(protocol::kFirmwareVersion).text();
}

std::string Ev3Board::program_name() const {
  return std::filesystem::path(options_.command.back()).stem().string();
}

std::string Ev3Board::emulator_name() const { return "qemu-arm"; }

std::optional<pid_t> Ev3Board::pid() const {
  return program_ ? std::optional<pid_t>(program_->pid()) : std::nullopt;
}

}  // namespace echomap::ev3

// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hil_mock/ev3/clock_server.hpp"
#include "hil_mock/ev3/firmware_process.hpp"
#include "hil_mock/ev3/lego_sensor.hpp"
#include "hil_mock/ev3/own_folder.hpp"
#include "hil_mock/ev3/range_sensor.hpp"
#include "hil_mock/ev3/tacho_motor.hpp"
#include "hil_mock/runner/simulated_board.hpp"

namespace echomap::ev3 {

/// What the brick runs, and what is plugged into it.
struct Ev3Options {
  /// The program with the words before it, as `under_qemu` gives them.
  std::vector<std::string> command;
  RangeSensor range_sensor = RangeSensor::kUltrasonic;
  /// Of real time: a program that is still busy then hangs, and simulated time goes on without it.
  std::chrono::milliseconds busy_limit{5000};
};

/// The command that runs an ELF of the EV3's processor.
std::vector<std::string> under_qemu(const std::filesystem::path& elf);

/// The robot's EV3 brick: the release ELF under qemu-arm, with files in place of ev3dev's sysfs and
/// simulated time in place of its clock. Its pins are those of its ports: encoder edges become
/// positions, echoes become ranges.
class Ev3Board final : public runner::SimulatedBoard {
 public:
  /// Starts the program at time 0. Throws std::runtime_error where it does not come up.
  explicit Ev3Board(Ev3Options options);
  ~Ev3Board() override;

  std::int64_t now_ns() const override { return now_ns_; }
  /// Throws std::runtime_error for what the kernel of the brick would refuse.
  void run_until(std::int64_t until_ns) override;
  /// Somebody switches the brick off and on: the program is up again after a while.
  void reset() override;
  void receive(std::span<const std::uint8_t> bytes) override;

  world::DriverInputs driver_inputs(runner::Wheel wheel,
                                    world::DriverInterface interface) const override;
  /// 1500 and the pan motor's position: a microsecond is a degree of its shaft.
  double pan_pulse_us() const override;
  void schedule_encoder_edge(runner::Wheel wheel, std::int64_t at_ns, bool a, bool b) override;
  void schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) override;
  void set_bump(runner::Wheel side, bool closed) override;

  /// There are no spare pins: throws std::invalid_argument, as the next two.
  void set_aux_level(unsigned pin, bool high) override;
  void schedule_aux_pulse(unsigned pin, std::int64_t fall_ns, std::int64_t rise_ns) override;
  void set_aux_millivolts(unsigned pin, double millivolts) override;
  bool aux_output(unsigned pin) const override;
  /// An MPU-6050 there stands for the gyro at in3.
  void connect(world::TwoWireDevice& device) override;

  std::string board_name() const override { return "ev3"; }
  std::string firmware_name() const override;
  std::string emulator_name() const override;

  /// Stands for /sys.
  std::filesystem::path sysfs() const { return folder_.path() / "sys"; }
  /// The program's process, the guard's; empty while the brick is off.
  std::optional<pid_t> pid() const;
  /// How many processes have asked for the time since the brick was switched on.
  std::size_t processes_seen() const { return clock_.connections() - connections_before_; }

 private:
  struct Edge {
    std::int64_t at_ns;
    unsigned phase;
  };
  struct Wheel {
    std::deque<Edge> edges;
    unsigned phase = 0;
    std::int64_t counts = 0;
  };
  struct Echo {
    std::int64_t at_ns;
    double range_m;
  };

  std::string program_name() const;
  void start_program();
  void step_to(std::int64_t to_ns);
  std::int64_t next_event_ns() const;
  void let_program_run();
  void obey_files();
  void deliver_bytes();
  void show_positions();
  void show_range();
  void show_gyro();
  Wheel& wheel_of(runner::Wheel wheel);

  OwnFolder folder_;
  Ev3Options options_;
  ClockServer clock_;
  TachoMotor pan_motor_;
  TachoMotor left_motor_;
  TachoMotor right_motor_;
  LegoSensor left_touch_;
  LegoSensor right_touch_;
  LegoSensor gyro_;
  RangeSensorFacts range_facts_;
  LegoSensor range_;
  std::unique_ptr<FirmwareProcess> program_;
  std::size_t connections_before_ = 0;
  Wheel left_;
  Wheel right_;
  std::optional<Echo> echo_;
  world::TwoWireDevice* gyro_chip_ = nullptr;
  double turned_deg_ = 0.0;
  std::vector<std::uint8_t> to_program_;
  std::vector<std::uint8_t> from_program_;
  std::vector<std::uint8_t> sent_;
  std::int64_t now_ns_ = 0;
  std::int64_t starts_ns_ = 0;
};

}  // namespace echomap::ev3

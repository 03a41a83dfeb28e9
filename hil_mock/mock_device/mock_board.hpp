// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "firmware/boards/native/native_board.hpp"
#include "hil_mock/runner/simulated_board.hpp"

namespace echomap::mock_device {

/// The native firmware as a simulated board. Several take turns in the one memory that the process
/// has for the program: no two may run at once, in threads.
class MockBoard final : public runner::SimulatedBoard {
 public:
  /// Switches on at time 0.
  MockBoard();
  MockBoard(const MockBoard&) = delete;
  MockBoard& operator=(const MockBoard&) = delete;

  std::int64_t now_ns() const override { return board_.now_ns(); }
  void run_until(std::int64_t until_ns) override { board_.run_until_ns(until_ns); }
  void reset() override { board_.reset(); }
  void receive(std::span<const std::uint8_t> bytes) override;
  world::DriverInputs driver_inputs(runner::Wheel wheel,
                                    world::DriverInterface interface) const override;
  double pan_pulse_us() const override { return board_.pan_pulse_us(); }
  void schedule_encoder_edge(runner::Wheel wheel, std::int64_t at_ns, bool a, bool b) override;
  void schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) override;
  void set_bump(runner::Wheel side, bool pressed) override;
  void set_aux_level(unsigned pin, bool high) override;
  void schedule_aux_pulse(unsigned pin, std::int64_t fall_ns, std::int64_t rise_ns) override;
  void set_aux_millivolts(unsigned pin, double millivolts) override;
  bool aux_output(unsigned pin) const override;
  void connect(world::TwoWireDevice& device) override;
  std::string board_name() const override { return "native"; }
  std::string firmware_name() const override;
  std::string emulator_name() const override;

 private:
  native::NativeBoard board_;
};

}  // namespace echomap::mock_device

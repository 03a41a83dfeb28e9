// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hil_mock/runner/simulated_board.hpp"

namespace echomap::runner {

/// A board without a program: the test sets its pins and looks at what reaches them. It sends back
/// every byte that it receives, and stops its motors at `stop_at_ns`.
class FakeBoard : public SimulatedBoard {
 public:
  static constexpr double kPwmPeriodUs = 128.0;

  struct Edge {
    std::int64_t at_ns;
    bool a;
    bool b;
  };
  struct AuxPulse {
    unsigned pin;
    std::int64_t fall_ns;
    std::int64_t rise_ns;
  };
  struct Echo {
    std::int64_t rise_ns;
    std::int64_t fall_ns;
  };

  std::int64_t now_ns() const override { return time_ns; }
  void run_until(std::int64_t until_ns) override {
    time_ns = until_ns;
    for (const std::uint8_t byte : received) {
      on_sent(byte);
    }
    received.clear();
    if (time_ns >= stop_at_ns) {
      duty = {};
    }
  }
  void reset() override { ++resets; }
  void receive(std::span<const std::uint8_t> bytes) override {
    received.insert(received.end(), bytes.begin(), bytes.end());
    received_at_ns = time_ns;
  }
  void plug_line(bool in) override { plugged.push_back(in); }
  world::DriverInputs driver_inputs(Wheel wheel, world::DriverInterface interface) const override {
    return world::inputs_for(
        interface, wheel == Wheel::kLeft ? duty.left : duty.right, false, kPwmPeriodUs);
  }
  double pan_pulse_us() const override { return pulse_us; }
  void schedule_encoder_edge(Wheel wheel, std::int64_t at_ns, bool a, bool b) override {
    (wheel == Wheel::kLeft ? left_edges : right_edges).push_back({at_ns, a, b});
    early_edges += at_ns < time_ns ? 1 : 0;
  }
  void schedule_aux_pulse(unsigned pin, std::int64_t fall_ns, std::int64_t rise_ns) override {
    aux_pulses.push_back({pin, fall_ns, rise_ns});
  }
  void schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) override {
    echoes.push_back({rise_ns, fall_ns});
  }
  void set_bump(Wheel side, bool pressed) override {
    (side == Wheel::kLeft ? left_bump : right_bump) = pressed;
  }
  void set_aux_level(unsigned pin, bool high) override { aux_levels.at(pin) = high; }
  void set_aux_millivolts(unsigned pin, double millivolts) override {
    aux_millivolts.at(pin) = millivolts;
  }
  bool aux_output(unsigned pin) const override { return aux_outputs.at(pin); }
  void connect(world::TwoWireDevice& device) override { two_wire_device = &device; }
  std::string board_name() const override { return board; }
  std::string firmware_name() const override { return "fake 1.0"; }
  std::string emulator_name() const override { return "none"; }

  std::int64_t time_ns = 0;
  int resets = 0;
  std::vector<bool> plugged;  ///< What plug_line has told, in turn.
  std::int64_t stop_at_ns = INT64_MAX;
  std::int64_t received_at_ns = -1;
  MotorDuty duty;
  double pulse_us = 0.0;
  std::vector<std::uint8_t> received;
  std::vector<Edge> left_edges;
  std::vector<Edge> right_edges;
  int early_edges = 0;
  std::vector<AuxPulse> aux_pulses;
  std::vector<Echo> echoes;
  bool left_bump = false;
  bool right_bump = false;
  std::array<std::optional<bool>, 16> aux_levels;
  std::array<std::optional<double>, 16> aux_millivolts;
  std::array<bool, 16> aux_outputs{};
  world::TwoWireDevice* two_wire_device = nullptr;
  std::string board = "fake";
};

}  // namespace echomap::runner

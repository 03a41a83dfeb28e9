// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "hil_mock/line_faults/delayed_line.hpp"
#include "hil_mock/line_faults/faulty_line.hpp"
#include "hil_mock/runner/simulated_board.hpp"

namespace echomap::runner {

/// What a line does to the bytes that pass: faults, then delays where there are any.
struct LineModel {
  line_faults::LineFaults faults{};  ///< Its seed is that of the delays, too.
  std::optional<line_faults::LineDelays> delays{};
};

/// A board behind a line: what it receives and sends suffers there, all else passes. Its plug is
/// out while nothing passes. A function of the bytes, their times and the seed alone, in lockstep
/// as in paced time.
class FaultyBoard final : public SimulatedBoard {
 public:
  /// Takes the hooks of `board`.
  FaultyBoard(std::unique_ptr<SimulatedBoard> board, const LineModel& line);

  /// From now on nothing passes for so long, not even what is on its way.
  void cut_cable(std::int64_t for_ns);

  std::int64_t now_ns() const override { return board_->now_ns(); }
  void run_until(std::int64_t until_ns) override;
  void reset() override { board_->reset(); }
  void receive(std::span<const std::uint8_t> bytes) override;
  world::DriverInputs driver_inputs(Wheel wheel, world::DriverInterface interface) const override {
    return board_->driver_inputs(wheel, interface);
  }
  double pan_pulse_us() const override { return board_->pan_pulse_us(); }
  void schedule_encoder_edge(Wheel wheel, std::int64_t at_ns, bool a, bool b) override {
    board_->schedule_encoder_edge(wheel, at_ns, a, b);
  }
  void schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) override {
    board_->schedule_echo(rise_ns, fall_ns);
  }
  void set_bump(Wheel side, bool pressed) override { board_->set_bump(side, pressed); }
  void set_aux_level(unsigned pin, bool high) override { board_->set_aux_level(pin, high); }
  void schedule_aux_pulse(unsigned pin, std::int64_t fall_ns, std::int64_t rise_ns) override {
    board_->schedule_aux_pulse(pin, fall_ns, rise_ns);
  }
  void set_aux_millivolts(unsigned pin, double millivolts) override {
    board_->set_aux_millivolts(pin, millivolts);
  }
  bool aux_output(unsigned pin) const override { return board_->aux_output(pin); }
  void connect(world::TwoWireDevice& device) override { board_->connect(device); }
  std::string board_name() const override { return board_->board_name(); }
  std::string firmware_name() const override { return board_->firmware_name(); }
  std::string emulator_name() const override { return board_->emulator_name(); }

 private:
  bool is_cut() const { return board_->now_ns() < cut_until_ns_; }
  bool is_away() const;
  void move_plug();
  void take_from_board(std::uint8_t byte);
  void give_to_host(std::span<const std::uint8_t> bytes);

  std::unique_ptr<SimulatedBoard> board_;
  line_faults::LineFaults faults_;
  line_faults::FaultyLine to_robot_;
  line_faults::FaultyLine to_host_;
  std::optional<line_faults::DelayedLine> delay_to_robot_;
  std::optional<line_faults::DelayedLine> delay_to_host_;
  std::int64_t cut_until_ns_ = 0;
  bool is_plugged_ = true;
};

}  // namespace echomap::runner

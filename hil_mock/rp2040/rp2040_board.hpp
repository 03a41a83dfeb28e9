// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "hil_mock/rp2040/chip_link.hpp"
#include "hil_mock/rp2040/pin_signals.hpp"
#include "hil_mock/rp2040/usb_cable.hpp"
#include "hil_mock/rp2040/usb_host.hpp"
#include "hil_mock/runner/simulated_board.hpp"

namespace echomap::rp2040 {

/// Which of its two lines the robot uses.
enum class PicoLine : std::uint8_t { kUsb, kUart };

/// Why the chip starts again.
enum class ResetCause : std::uint8_t { kPowerOn, kPin };

/// The robot's Raspberry Pi Pico: the release ELF on the RP2040 of rp2040js, its pins as a
/// SimulatedBoard. Times are rounded up to whole instructions.
class Rp2040Board final : public runner::SimulatedBoard, private UsbCable {
 public:
  /// Loads `elf` and switches on at time 0. Throws std::runtime_error where it cannot be loaded.
  Rp2040Board(const std::filesystem::path& elf, PicoLine line);

  std::int64_t now_ns() const override;
  void run_until(std::int64_t until_ns) override;
  void reset() override { reset(ResetCause::kPin); }
  void reset(ResetCause cause);

  void receive(std::span<const std::uint8_t> bytes) override;
  void plug_line(bool in) override;

  world::DriverInputs driver_inputs(runner::Wheel wheel,
                                    world::DriverInterface interface) const override {
    return signals_.driver_inputs(wheel, interface);
  }
  double pan_pulse_us() const override { return signals_.pan_pulse_us(); }
  void schedule_encoder_edge(runner::Wheel wheel, std::int64_t at_ns, bool a, bool b) override;
  void schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) override;
  void set_bump(runner::Wheel side, bool pressed) override;

  /// Throws std::invalid_argument, as the next two, for a pin that cannot be that.
  void set_aux_level(unsigned pin, bool high) override;
  void schedule_aux_pulse(unsigned pin, std::int64_t fall_ns, std::int64_t rise_ns) override;
  void set_aux_millivolts(unsigned pin, double millivolts) override;
  bool aux_output(unsigned pin) const override;
  void connect(world::TwoWireDevice& device) override;

  std::string board_name() const override { return "pico"; }
  std::string firmware_name() const override;
  std::string emulator_name() const override { return "rp2040js 1.4.1"; }

  /// Resets since switch-on, by whatever cause.
  std::uint32_t resets() const { return resets_; }
  /// The host on the USB cable.
  UsbHost& usb_host() { return host_; }
  /// Reads or writes a word of the chip as the program would.
  std::uint32_t peek(std::uint32_t address);
  void poke(std::uint32_t address, std::uint32_t value);
  /// The program goes on there.
  void jump(std::uint32_t address);
  /// What the program takes of its chip, and how late or early its tick is at most.
  struct Load {
    double busy_share;
    double tick_jitter_us;
  };
  /// load() is of the time from now on.
  void meter_load();
  Load load();
  /// A device on the two-wire bus has so many bits left to send.
  void hold_two_wire_bus(unsigned bits);

 private:
  void plug(bool plugged) override;
  bool is_attached() const override { return attached_; }
  bool has_bulk_in() const override { return has_bulk_in_; }
  void reset_bus() override;
  void suspend_bus() override;
  void resume_bus(UsbResume resume) override;
  UsbAnswer setup(std::uint8_t address, std::span<const std::uint8_t> packet) override;
  UsbData in(std::uint8_t address, std::uint8_t endpoint) override;
  UsbAnswer out(std::uint8_t address,
                std::uint8_t endpoint,
                bool data1,
                std::span<const std::uint8_t> bytes) override;

  void drive(std::int64_t at_ns, std::uint8_t pin, bool level);
  void exchange();
  bool replay(Message& events);
  void replay_pins(Message& events);
  void answer_register(Message& events, bool reads);
  UsbData transact(char kind,
                   std::uint8_t address,
                   std::uint8_t endpoint,
                   bool data1,
                   std::span<const std::uint8_t> bytes);

  std::string program_;
  ChipLink chip_;
  PicoLine line_;
  UsbHost host_;
  Message orders_;
  PinSignals signals_;
  std::array<std::int8_t, 32> driven_levels_{};
  std::vector<world::TwoWireDevice*> devices_;
  UsbData usb_data_;
  std::uint32_t peeked_ = 0;
  Load load_{};
  std::uint32_t resets_ = 0;
  bool attached_ = false;
  bool has_bulk_in_ = false;
  std::int64_t poll_ns_ = 0;
  std::int64_t chip_ns_ = 0;
  std::int64_t until_ns_ = 0;
  std::int64_t host_due_ns_ = 0;
  std::int64_t trigger_rise_ns_ = 0;
};

}  // namespace echomap::rp2040

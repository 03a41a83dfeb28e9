// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "hil_mock/runner/simulated_board.hpp"

namespace echomap::tests {

/// A board in its emulator, and what the tests do to its chip. No program may link two emulators
/// (their licences do not fit), so each test program has one, and these functions from its file
/// simavr_under_test.cpp or unicorn_under_test.cpp.
class EmulatedBoard {
 public:
  virtual ~EmulatedBoard() = default;

  /// Its pins and its serial line.
  virtual runner::SimulatedBoard& pins() = 0;
  /// The supply goes off and on: RAM is lost.
  virtual void cut_power() = 0;
  virtual void pull_reset_pin() = 0;
  /// How often the chip has been reset since switch-on, by whatever cause.
  virtual std::uint32_t resets() const = 0;
  /// Level and direction registers of all ports; none where the emulator does not tell.
  virtual std::vector<std::uint8_t> port_registers() { return {}; }
  /// The tick's interrupt never comes again, until a reset.
  virtual void stop_ticks() = 0;
  /// The program hangs in an endless loop with interrupts unlocked.
  virtual void hang() = 0;
  /// Whether the watchdog's warning ends in the reset itself, behind the motors' cut.
  virtual bool resets_in_the_warning() const { return false; }
  /// The program ends at once: a system kills it, or the core takes a fault. No AVR has either.
  virtual void crash() {}
  /// A bootloader clears the cause of every reset before the program sees it; only on boards whose
  /// bootloader does.
  virtual void hide_reset_cause() {}
  /// A device on the two-wire bus was cut off and has so many bits left to send.
  virtual void hold_two_wire_bus(unsigned bits) = 0;
};

/// Switches a board with this program on, at time 0.
std::unique_ptr<EmulatedBoard> make_emulated_board(const std::filesystem::path& elf);

/// The images of this emulator's boards that a user flashes: "echomap-uno", ..
std::vector<const char*> flashed_images();
/// The same with every baud rate that there is an image for.
std::vector<const char*> images_of_every_baud();
/// Those of them whose board can tell that both pins of an encoder have changed at once.
std::vector<const char*> images_that_tell_lost_steps();
/// Those that send every whole frame back.
std::vector<const char*> vector_images();

}  // namespace echomap::tests

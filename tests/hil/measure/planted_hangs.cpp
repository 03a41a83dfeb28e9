// SPDX-License-Identifier: MIT
#include "tests/hil/measure/planted_hangs.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <stdexcept>

#include "hil_mock/emulator/simavr_board.hpp"
#include "tests/hil/measure/every_sensor.hpp"
#include "tests/hil/measure/source_lines.hpp"

namespace echomap::tests {
namespace {

emulator::AvrMachine& machine_of(RobotOnTheMove& moving) {
  return dynamic_cast<emulator::SimavrBoard&>(moving.robot.board()).machine();
}

void jump_to_itself(avr_t& core, std::uint32_t address) {
  constexpr std::uint8_t kJump[] = {0xFF, 0xCF};  // rjmp .
  std::copy(std::begin(kJump), std::end(kJump), core.flash + address);
}

/// A robot that does everything at once: it drives, sweeps, reads every sensor and is read from.
class BusyRobot {
 public:
  explicit BusyRobot(const std::filesystem::path& elf)
      : moving(elf), sensors_(moving.robot.board()) {
    if (!moving.robot.connect() || !sensors_.switch_on(moving.robot)) {
      throw std::runtime_error("the robot does not take its sensors");
    }
    moving.drive();
    moving.robot.send(protocol::StartSweep{100, -3000, 3000, 600, 0});
  }

  /// Until `done`, or for as long as each part of the program takes to come round; true when done.
  bool run_until(const std::function<bool()>& done) {
    for (std::uint16_t offset = 0; offset < 250 && !done(); offset += 50) {
      moving.robot.send(protocol::BulkRead{0, offset});
      moving.robot.run_until(done, 50);
    }
    return done();
  }

  RobotOnTheMove moving;

 private:
  EverySensor sensors_;
};

/// An address in each of the firmware's files at which a busy robot is, in its interrupts or
/// outside of them.
std::map<std::string, std::uint32_t> addresses_of_files(const std::filesystem::path& elf,
                                                        bool in_interrupts) {
  const SourceLines lines(elf);
  BusyRobot busy(elf);
  emulator::AvrMachine& machine = machine_of(busy.moving);
  std::map<std::string, std::uint32_t> addresses;
  machine.on_instruction = [&](std::uint32_t address) {
    const std::string& file = lines.file_at(address);
    if (file.starts_with("firmware/") &&
        (machine.core().interrupts.running_ptr != 0) == in_interrupts) {
      addresses.emplace(file, address);
    }
  };
  busy.run_until([] { return false; });
  machine.on_instruction = nullptr;
  return addresses;
}

}  // namespace

void hang_with_interrupts_locked(RobotOnTheMove& moving) {
  avr_t& core = machine_of(moving).core();
  const std::uint32_t trap = core.flashend - 1;
  jump_to_itself(core, trap);
  core.sreg[S_I] = 0;
  core.pc = trap;
  core.state = cpu_Running;
}

void plant_hangs(const std::filesystem::path& elf, const HangReport& report) {
  for (const bool in_interrupt : {false, true}) {
    for (const auto& [file, address] : addresses_of_files(elf, in_interrupt)) {
      BusyRobot busy(elf);
      emulator::AvrMachine& machine = machine_of(busy.moving);
      jump_to_itself(machine.core(), address);
      if (!busy.run_until([&] { return machine.core().pc == address; })) {
        throw std::runtime_error("the robot does not come to " + file);
      }
      report({file, in_interrupt}, busy.moving.outcome_of_hang());
    }
  }
}

double measure_hang_ms(const std::filesystem::path& elf) {
  double longest_ms = 0.0;
  plant_hangs(elf, [&](const HangPlace&, const HangOutcome& outcome) {
    longest_ms = std::max(longest_ms, outcome.off_ms);
  });
  return longest_ms;
}

}  // namespace echomap::tests

// SPDX-License-Identifier: MIT
#include "tests/hil/measure/planted_hangs.hpp"

#include <algorithm>
#include <cstdint>
#include <map>

#include "hil_mock/emulator/simavr_board.hpp"
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

void drive_and_sweep(RobotOnTheMove& moving) {
  moving.drive();
  moving.robot.command(protocol::StartSweep{0, -3000, 3000, 600, 0});
}

/// An address of each file at which a driving robot is in a quarter of a second, in its interrupts
/// or outside of them.
std::map<std::string, std::uint32_t> addresses_of_files(const std::filesystem::path& elf,
                                                        bool in_interrupts) {
  const SourceLines lines(elf);
  RobotOnTheMove moving(elf);
  drive_and_sweep(moving);
  emulator::AvrMachine& machine = machine_of(moving);
  std::map<std::string, std::uint32_t> addresses;
  machine.on_instruction = [&](std::uint32_t address) {
    if ((machine.core().interrupts.running_ptr != 0) == in_interrupts) {
      addresses.emplace(lines.file_at(address), address);
    }
  };
  moving.robot.run_ms(250);
  machine.on_instruction = nullptr;
  return addresses;
}

}  // namespace

const std::set<std::string>& files_of_tasks() {
  static const std::set<std::string> kFiles{"firmware/tasks/safety.cpp",
                                            "firmware/tasks/command.cpp",
                                            "firmware/tasks/telemetry.cpp",
                                            "firmware/tasks/heartbeat.cpp",
                                            "firmware/control/wheel_motion.cpp",
                                            "firmware/control/wheel_speed_controller.cpp",
                                            "firmware/control/scan_sweep.cpp",
                                            "firmware/boards/avr_common/tick.cpp",
                                            "firmware/boards/avr_common/uart.cpp"};
  return kFiles;
}

void hang_with_interrupts_locked(RobotOnTheMove& moving) {
  avr_t& core = machine_of(moving).core();
  const std::uint32_t trap = core.flashend - 1;
  jump_to_itself(core, trap);
  core.sreg[S_I] = 0;
  core.pc = trap;
  core.state = cpu_Running;
}

void plant_hangs(const std::filesystem::path& elf, const HangReport& report) {
  for (const bool in_interrupts : {false, true}) {
    for (const auto& [file, address] : addresses_of_files(elf, in_interrupts)) {
      if (!files_of_tasks().contains(file)) {
        continue;
      }
      RobotOnTheMove moving(elf);
      drive_and_sweep(moving);
      jump_to_itself(machine_of(moving).core(), address);
      report(file, in_interrupts, moving.outcome_of_hang());
    }
  }
}

double measure_hang_ms(const std::filesystem::path& elf) {
  double longest_ms = 0.0;
  plant_hangs(elf, [&](const std::string&, bool, const HangOutcome& outcome) {
    longest_ms = std::max(longest_ms, outcome.off_ms);
  });
  return longest_ms;
}

}  // namespace echomap::tests

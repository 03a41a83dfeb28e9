// SPDX-License-Identifier: MIT
#include "hil_mock/emulator/chip_modules.hpp"
#include "hil_mock/emulator/simavr_board.hpp"
#include "tests/hil/emulated_board.hpp"

namespace echomap::tests {
namespace {

using emulator::ResetSource;

class SimavrUnderTest final : public EmulatedBoard {
 public:
  explicit SimavrUnderTest(const std::filesystem::path& elf) : board_(elf) {}

  runner::SimulatedBoard& pins() override { return board_; }
  void cut_power() override { board_.machine().reset(ResetSource::kPowerOn); }
  void pull_reset_pin() override { board_.machine().reset(ResetSource::kExternal); }
  std::uint32_t resets() const override { return board_.machine().resets(); }

  std::vector<std::uint8_t> port_registers() override {
    const avr_t& core = board_.machine().core();
    std::vector<std::uint8_t> registers;
    for (const char port : {'B', 'C', 'D'}) {
      const avr_ioport_t& found = emulator::find_port(core, port);
      registers.push_back(core.data[found.r_port]);
      registers.push_back(core.data[found.r_ddr]);
    }
    return registers;
  }

  void stop_ticks() override {
    avr_t& core = board_.machine().core();
    core.data[emulator::find_timer(core, '2').overflow.enable.reg] = 0;  // TIMSK2
  }

  void hang() override {
    avr_t& core = board_.machine().core();
    const std::uint32_t trap = core.flashend - 1;
    constexpr std::uint8_t kJumpToItself[] = {0xFF, 0xCF};  // rjmp .
    core.flash[trap] = kJumpToItself[0];
    core.flash[trap + 1] = kJumpToItself[1];
    core.pc = trap;
    core.state = cpu_Running;
    core.sreg[S_I] = 1;  // It may have been in an interrupt or a lock.
  }

  void hide_reset_cause() override {
    emulator::AvrMachine& machine = board_.machine();
    machine.hooks().replace_read(machine.core().reset_flags.porf.reg, [] { return 0; });
  }

  void hold_two_wire_bus(unsigned bits) override { board_.two_wire_bus().hold(bits); }

 private:
  emulator::SimavrBoard board_;
};

}  // namespace

std::unique_ptr<EmulatedBoard> make_emulated_board(const std::filesystem::path& elf) {
  return std::make_unique<SimavrUnderTest>(elf);
}

std::vector<const char*> flashed_images() { return {"echomap-uno", "echomap-mega"}; }

std::vector<const char*> images_of_every_baud() {
  return {"echomap-uno",
          "echomap-uno-115200",
          "echomap-uno-500000",
          "echomap-mega",
          "echomap-mega-115200",
          "echomap-mega-500000"};
}

std::vector<const char*> images_that_tell_lost_steps() { return flashed_images(); }

std::vector<const char*> vector_images() { return {"echomap-uno-vectors", "echomap-mega-vectors"}; }

}  // namespace echomap::tests

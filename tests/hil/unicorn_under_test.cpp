// SPDX-License-Identifier: MIT
#include <array>

#include "hil_mock/unicorn/unicorn_board.hpp"
#include "tests/hil/emulated_board.hpp"

namespace echomap::tests {
namespace {

using unicorn::ResetSource;

class UnicornUnderTest final : public EmulatedBoard {
 public:
  explicit UnicornUnderTest(const std::filesystem::path& elf) : board_(elf) {}

  runner::SimulatedBoard& pins() override { return board_; }
  void cut_power() override { board_.chip().reset(ResetSource::kPowerOn); }
  void pull_reset_pin() override { board_.chip().reset(ResetSource::kExternal); }
  std::uint32_t resets() const override { return board_.chip().resets(); }

  void stop_ticks() override {
    constexpr std::uint32_t kCtrl = 0;
    board_.chip().sys_tick().write(kCtrl, 0);
  }

  void hang() override {
    constexpr std::uint32_t kTrap = 0x08006000;                           // Behind the program.
    constexpr std::array<std::uint8_t, 4> kHang{0x62, 0xB6, 0xFE, 0xE7};  // cpsie i; b .
    board_.chip().core().write_memory(kTrap, kHang);
    board_.chip().core().jump_to(kTrap);
  }

  /// Where the core goes with a fault.
  void crash() override {
    constexpr std::uint32_t kTrap = 0x08006000;
    constexpr std::array<std::uint8_t, 12> kFault{0x01,
                                                  0x48,  // ldr r0, [pc, #4]
                                                  0x00,
                                                  0x68,  // ldr r0, [r0]
                                                  0x00,
                                                  0x47,  // bx r0
                                                  0x00,
                                                  0xBF,  // nop
                                                  0x0C,
                                                  0x00,
                                                  0x00,
                                                  0x08};
    board_.chip().core().write_memory(kTrap, kFault);
    board_.chip().core().jump_to(kTrap);
  }

  void hold_two_wire_bus(unsigned bits) override { board_.chip().hold_two_wire_bus(bits); }

 private:
  unicorn::UnicornBoard board_;
};

}  // namespace

std::unique_ptr<EmulatedBoard> make_emulated_board(const std::filesystem::path& elf) {
  return std::make_unique<UnicornUnderTest>(elf);
}

std::vector<const char*> flashed_images() { return {"echomap-stm32f103"}; }

std::vector<const char*> images_of_every_baud() {
  return {"echomap-stm32f103", "echomap-stm32f103-115200", "echomap-stm32f103-500000"};
}

/// Its timers count, and cannot see a lost step.
std::vector<const char*> images_that_tell_lost_steps() { return {}; }

std::vector<const char*> vector_images() { return {"echomap-stm32f103-vectors"}; }

}  // namespace echomap::tests

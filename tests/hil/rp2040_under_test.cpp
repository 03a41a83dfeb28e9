// SPDX-License-Identifier: MIT
#include "hil_mock/rp2040/rp2040_board.hpp"
#include "tests/hil/emulated_board.hpp"

namespace echomap::tests {
namespace {

/// On its pins GP0 and GP1, at the pace of a serial line: rp2040_test.cpp has the USB cable.
class Rp2040UnderTest final : public EmulatedBoard {
 public:
  explicit Rp2040UnderTest(const std::filesystem::path& elf)
      : board_(elf, rp2040::PicoLine::kUart) {}

  runner::SimulatedBoard& pins() override { return board_; }
  void cut_power() override { board_.reset(rp2040::ResetCause::kPowerOn); }
  void pull_reset_pin() override { board_.reset(rp2040::ResetCause::kPin); }
  std::uint32_t resets() const override { return board_.resets(); }

  void stop_ticks() override {
    constexpr std::uint32_t kClearTimerInte = 0x4005'4038 + 0x3000;
    constexpr std::uint32_t kAlarm0 = 1;
    board_.poke(kClearTimerInte, kAlarm0);
  }

  void hang() override {
    constexpr std::uint32_t kTrap = 0x2003'0000;  // Behind program and stack.
    constexpr std::uint32_t kHang = 0xE7FE'B662;  // cpsie i; b .
    board_.poke(kTrap, kHang);
    board_.jump(kTrap);
  }

  /// Where the core goes with a fault.
  void crash() override {
    constexpr std::uint32_t kVectorTableOffset = 0xE000'ED08;
    constexpr std::uint32_t kHardFault = 3 * 4;
    board_.jump(board_.peek(board_.peek(kVectorTableOffset) + kHardFault) & ~std::uint32_t{1});
  }

  bool resets_in_the_warning() const override { return true; }
  void hold_two_wire_bus(unsigned bits) override { board_.hold_two_wire_bus(bits); }

 private:
  rp2040::Rp2040Board board_;
};

}  // namespace

std::unique_ptr<EmulatedBoard> make_emulated_board(const std::filesystem::path& elf) {
  return std::make_unique<Rp2040UnderTest>(elf);
}

std::vector<const char*> flashed_images() { return {"echomap-pico"}; }

std::vector<const char*> images_that_tell_lost_steps() { return flashed_images(); }

std::vector<const char*> images_of_every_baud() { return {"echomap-pico"}; }

std::vector<const char*> vector_images() { return {"echomap-pico-vectors"}; }

}  // namespace echomap::tests

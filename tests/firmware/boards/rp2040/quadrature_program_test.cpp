// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/quadrature_program.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::boards {
namespace {

/// A state machine of the PIO as far as the program needs it, from the data sheet's section 3.4: a
/// cycle is one instruction.
class StateMachine {
 public:
  explicit StateMachine(std::uint8_t pins) : pins_(pins), osr_(pins) {}

  void set_pins(std::uint8_t pins) { pins_ = pins; }
  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      step(program_.word[pc_]);
    }
  }
  std::int16_t read() {
    fifo_.reset();
    run(16);
    return static_cast<std::int16_t>(fifo_.value());
  }
  bool take_flag() {
    const bool was = flag_;
    flag_ = false;
    return was;
  }
  /// Cycles of the longest way from one look at the pins to the next so far.
  int longest_round() const { return longest_round_; }

 private:
  void step(std::uint16_t word) {
    ++cycles_;
    const auto next = static_cast<std::uint8_t>(
        pc_ == QuadratureProgram::kUp + 2 ? QuadratureProgram::kTell : pc_ + 1);
    pc_ = next;
    const std::uint16_t data = word & 0x1F;
    switch (word) {
      case pio::kPush:
        if (!fifo_) {
          fifo_ = isr_;
        }
        isr_ = 0;
        return;
      case pio::kMovXStatus:
        x_ = fifo_ ? 0 : 0xFFFFFFFF;
        return;
      case pio::kMovYNotY:
        y_ = ~y_;
        return;
      case pio::kMovPcIsr:
        pc_ = static_cast<std::uint8_t>(isr_ & 0x1F);
        return;
      case pio::kMovIsrY:
        isr_ = y_;
        return;
      case pio::kMovOsrIsr:
        osr_ = isr_;
        return;
      case pio::kIrqOwn:
        flag_ = true;
        return;
      case pio::out_isr(2):
        isr_ = osr_ & 3;
        osr_ >>= 2;
        return;
      case pio::in_pins(2):
        isr_ = isr_ << 2 | pins_;
        look();
        return;
      default:
        jump(word & 0xFFE0, static_cast<std::uint8_t>(data));
    }
  }

  void jump(std::uint16_t kind, std::uint8_t address) {
    if (kind == pio::jmp(0) || (kind == pio::jmp_not_x(0) && x_ == 0) ||
        (kind == pio::jmp_y_down(0) && y_ != 0)) {
      pc_ = address;
    } else if (kind != pio::jmp_not_x(0) && kind != pio::jmp_y_down(0)) {
      throw std::runtime_error("an instruction that the program has not");
    }
    if (kind == pio::jmp_y_down(0)) {
      --y_;
    }
  }

  void look() {
    if (last_look_ != 0) {
      longest_round_ = std::max(longest_round_, cycles_ - last_look_);
    }
    last_look_ = cycles_;
  }

  const QuadratureProgram program_;
  std::uint8_t pins_;
  std::uint32_t osr_;
  std::uint32_t isr_ = 0;
  std::uint32_t x_ = 0;
  std::uint32_t y_ = 0;
  std::uint8_t pc_ = QuadratureProgram::kTell;
  bool flag_ = false;
  std::optional<std::uint32_t> fifo_;
  int cycles_ = 0;
  int last_look_ = 0;
  int longest_round_ = 0;
};

constexpr std::uint8_t forward_order[] = {0b00, 0b01, 0b11, 0b10};

TEST(QuadratureProgram, FitsIntoTheMemoryOfAPio) { EXPECT_LE(QuadratureProgram::kWords, 32); }

TEST(QuadratureProgram, CountsNothingAtTheStartWhateverTheLevels) {
  for (const std::uint8_t levels : forward_order) {
    StateMachine machine(levels);
    machine.run(100);
    EXPECT_EQ(machine.read(), 0);
    EXPECT_FALSE(machine.take_flag());
  }
}

TEST(QuadratureProgram, CountsUpWhenALeadsAndDownBelowZeroWhenBLeads) {
  StateMachine machine(forward_order[0]);
  for (int edge = 1; edge <= 1000; ++edge) {
    machine.set_pins(forward_order[edge & 3]);
    machine.run(20);
  }
  EXPECT_EQ(machine.read(), 1000);
  for (int edge = 999; edge >= -40'000; --edge) {
    machine.set_pins(forward_order[edge & 3]);
    machine.run(20);
  }
  EXPECT_EQ(machine.read(), static_cast<std::int16_t>(-40'000));
  EXPECT_FALSE(machine.take_flag());
}

TEST(QuadratureProgram, IsExactAtARandomWalkWithAnEdgeEvery14CyclesReadOrNot) {
  std::mt19937 random(1);
  StateMachine machine(forward_order[0]);
  int position = 0;
  for (int edge = 0; edge < 50'000; ++edge) {
    position += random() % 2 == 0 ? 1 : -1;
    machine.set_pins(forward_order[position & 3]);
    machine.run(14);
    if (random() % 50 == 0) {
      ASSERT_EQ(machine.read(), static_cast<std::int16_t>(position));
    }
  }
  EXPECT_EQ(machine.read(), static_cast<std::int16_t>(position));
  EXPECT_LE(machine.longest_round(), 13);
  EXPECT_FALSE(machine.take_flag());
}

TEST(QuadratureProgram, FlagsEveryJumpOfBothPinsAndCountsOn) {
  StateMachine machine(forward_order[0]);
  for (int jump = 1; jump <= 20; ++jump) {
    machine.set_pins(forward_order[(2 * jump) & 3]);
    machine.run(20);
    EXPECT_TRUE(machine.take_flag()) << jump;
  }
  machine.set_pins(forward_order[1]);
  EXPECT_EQ(machine.read(), 1);
  EXPECT_FALSE(machine.take_flag());
}

}  // namespace
}  // namespace echomap::boards

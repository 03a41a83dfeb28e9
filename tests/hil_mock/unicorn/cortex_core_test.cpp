// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/cortex_core.hpp"

#include <cstdint>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kFlash = 0x08000000;
constexpr std::uint32_t kStackTop = 0x20001000;
constexpr std::uint32_t kMain = kFlash + 0x100;
constexpr std::uint32_t kHandler = kFlash + 0x200;
constexpr std::uint32_t kPort = 0x40000000;

/// A core whose program writes numbers to a port, with one handler for SysTick and line 0.
class Core : public ::testing::Test {
 protected:
  Core() {
    core.map_rom(kFlash, 0x1000);
    core.map_ram(0x20000000, 0x1000);
    port.read = [](std::uint32_t, unsigned) { return 0U; };
    port.write = [this](std::uint32_t, unsigned, std::uint32_t value) { written.push_back(value); };
    core.map_device(kPort, 0x1000, port);
    write_words(kFlash, {kStackTop, kMain | 1});
    write_words(kFlash + 4 * Nvic::kSysTick, {kHandler | 1, kHandler | 1});
    nvic.write(0xE000E100, 1);
  }

  void write_words(std::uint32_t address, std::initializer_list<std::uint32_t> words) {
    const std::vector<std::uint32_t> copy(words);
    core.write_memory(address,
                      {reinterpret_cast<const std::uint8_t*>(copy.data()), 4 * copy.size()});
  }

  void write_code(std::uint32_t address, std::initializer_list<std::uint16_t> code) {
    const std::vector<std::uint16_t> copy(code);
    core.write_memory(address,
                      {reinterpret_cast<const std::uint8_t*>(copy.data()), 2 * copy.size()});
  }

  EventQueue queue;
  Nvic nvic;
  CortexCore core{queue, nvic};
  CortexCore::Device port;
  std::vector<std::uint32_t> written;
};

TEST_F(Core, SleepsUntilAnInterruptAndGoesOnBehindIt) {
  // mov.w r3, #0x40000000; wfi; movs r0, #2; str r0, [r3]; b .
  write_code(kMain, {0xF04F, 0x4380, 0xBF30, 0x2002, 0x6018, 0xE7FE});
  // movs r0, #1; str r0, [r3]; bx lr
  write_code(kHandler, {0x2001, 0x6018, 0x4770});
  core.reset();
  core.run_to(5'000);
  EXPECT_TRUE(written.empty());
  queue.at(10'000, [this] { nvic.pend_sys_tick(); });
  core.run_to(20'000);
  EXPECT_EQ(written, (std::vector<std::uint32_t>{1, 2}));
}

TEST_F(Core, GivesTheInterruptedProgramItsRegistersAndFlagsBack) {
  // mov.w r3, #0x40000000; movs r0, #7; cmp r0, #7; b loop
  // loop: bne fail; cmp r0, #7; b loop; fail: str r0, [r3]; b .
  write_code(kMain,
             {0xF04F, 0x4380, 0x2007, 0x2807, 0xE7FF, 0xD101, 0x2807, 0xE7FC, 0x6018, 0xE7FE});
  // movs r0, #9; cmp r0, #0; movs r1, #1; movs r2, #1; bx lr
  write_code(kHandler, {0x2009, 0x2800, 0x2101, 0x2201, 0x4770});
  core.reset();
  for (std::uint64_t cycle = 100; cycle < 20'000; cycle += 101) {
    queue.at(cycle, [this] {
      nvic.set_line(0, true);
      nvic.set_line(0, false);
    });
  }
  core.run_to(30'000);
  EXPECT_TRUE(written.empty()) << "the loop has seen another r0 or other flags";
}

TEST_F(Core, ServesAnInterruptWhenTheLockIsOpened) {
  nvic.write(0xE000E400, 0x10);
  // mov.w r3, #0x40000000; movs r0, #0x10; msr basepri, r0; str r0, [r3]; movs r0, #0;
  // msr basepri, r0; str r0, [r3]; b .
  write_code(
      kMain,
      {0xF04F, 0x4380, 0x2010, 0xF380, 0x8811, 0x6018, 0x2000, 0xF380, 0x8811, 0x6018, 0xE7FE});
  // movs r1, #1; str r1, [r3]; bx lr
  write_code(kHandler, {0x2101, 0x6019, 0x4770});
  port.write = [this](std::uint32_t, unsigned, std::uint32_t value) {
    written.push_back(value);
    nvic.set_line(0, value == 0x10);
  };
  core.reset();
  core.run_to(1'000);
  EXPECT_EQ(written, (std::vector<std::uint32_t>{0x10, 1, 0}));
}

TEST_F(Core, TakesACycleForEachHalfWord) {
  // movs r0, #0; adds r0, #1; adds r0, #1; b back to the first adds: three half-words a round
  write_code(kMain, {0x2000, 0x3001, 0x3001, 0xE7FC});
  core.reset();
  core.run_to(3'000);
  EXPECT_GE(queue.now(), 3'000U);
  EXPECT_LT(queue.now(), 3'004U);
}

TEST_F(Core, TakesThreeCyclesForEachHalfWordWhereItIsTold) {
  // mov.w r3, #0x40000000; movs r0, #0; adds r0, #1; str r0, [r3]; b back to adds
  write_code(kMain, {0xF04F, 0x4380, 0x2000, 0x3001, 0x6018, 0xE7FC});
  core.set_half_word_cycles(3);
  core.reset();
  core.run_to(9'000);
  EXPECT_NEAR(double(written.size()), 1'000.0, 2.0);
}

TEST_F(Core, SaysWhereAProgramHasCrashed) {
  write_code(kMain, {0xDE00});  // udf #0
  core.reset();
  EXPECT_THROW(core.run_to(100), std::runtime_error);
}

TEST_F(Core, RefusesToWriteTheProgramMemory) {
  // mov.w r3, #0x08000000; str r0, [r3]
  write_code(kMain, {0xF04F, 0x6300, 0x6018, 0xE7FE});
  core.reset();
  EXPECT_THROW(core.run_to(100), std::runtime_error);
}

}  // namespace
}  // namespace echomap::unicorn

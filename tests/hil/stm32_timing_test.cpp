// SPDX-License-Identifier: MIT
/// The STM32F103 under load, where its code costs what the emulator counts by habit, and where it
/// costs more than on the chip: docs/hardware/stm32f103.md, "Time in the emulator".
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <tuple>

#include <gtest/gtest.h>

#include "hil_mock/unicorn/unicorn_board.hpp"
#include "tests/hil/measure/loaded_robot.hpp"
#include "tests/hil/release_images.hpp"

namespace echomap::tests {
namespace {

using unicorn::Stm32Chip;

constexpr std::uint64_t kTickCycles = unicorn::kClockHz / 1000;

Stm32Chip& chip_of(LoadedRobot& robot) {
  return dynamic_cast<unicorn::UnicornBoard&>(robot.session().board()).chip();
}

/// How late the tick's interrupt is entered, beyond the least delay seen.
class TickJitter {
 public:
  explicit TickJitter(Stm32Chip& chip) : chip_(chip) {
    chip.core().on_enter = [this](unicorn::Exception exception) {
      if (exception == unicorn::Nvic::kSysTick) {
        note((chip_.cycle() - first_cycle_) % kTickCycles);
      }
    };
  }
  ~TickJitter() { chip_.core().on_enter = nullptr; }
  TickJitter(const TickJitter&) = delete;
  TickJitter& operator=(const TickJitter&) = delete;

  double us() const { return double(max_ - min_) * 1e6 / double(unicorn::kClockHz); }

 private:
  /// `phase` as a number of either sign, 0 for that of the first tick.
  void note(std::uint64_t phase) {
    const auto late = static_cast<std::int64_t>(phase);
    const auto signed_late = phase < kTickCycles / 2 ? late : late - std::int64_t{kTickCycles};
    min_ = std::min(min_, signed_late);
    max_ = std::max(max_, signed_late);
  }

  Stm32Chip& chip_;
  std::uint64_t first_cycle_ = chip_.cycle();
  std::int64_t min_ = INT64_MAX;
  std::int64_t max_ = INT64_MIN;
};

class Stm32UnderLoad : public ::testing::TestWithParam<std::tuple<unsigned, int>> {};

INSTANTIATE_TEST_SUITE_P(
    CyclesPerHalfWordAndEdgesPerS,
    Stm32UnderLoad,
    ::testing::Combine(::testing::Values(unicorn::kMinCyclesPerHalfWord,
                                         unicorn::kPessimisticCyclesPerHalfWord),
                       ::testing::Values(20'000, 40'000, 80'000)),
    [](const auto& test) {
      return std::to_string(std::get<0>(test.param)) + "_" +
             std::to_string(std::get<1>(test.param));
    });

TEST_P(Stm32UnderLoad, CountsHearsAndMeasuresRight) {
  constexpr double kSeconds = 10.0;
  const auto [cost, edges_per_s] = GetParam();
  LoadedRobot robot(release_image("echomap-stm32f103"), {.edges_per_s = double(edges_per_s)});
  Stm32Chip& chip = chip_of(robot);
  chip.set_cycles_per_half_word(cost);
  robot.connect();
  const TickJitter jitter(chip);
  const std::uint64_t slept_before = chip.core().slept_cycles();
  robot.run_s(kSeconds);
  const double slept = double(chip.core().slept_cycles() - slept_before);
  const double busy = 1.0 - slept / (kSeconds * double(unicorn::kClockHz));
  const LoadResult result = robot.finish();
  std::printf(
      "%u cycles a half-word, %d edges/s: busy %.1f %%, tick within %.1f us, echo %.2f us\n",
      cost,
      edges_per_s,
      100.0 * busy,
      jitter.us(),
      result.worst_echo_error_us);
  EXPECT_EQ(result.miscounts, 0);
  EXPECT_EQ(result.encoder_errors, 0);
  EXPECT_TRUE(result.under_control);
  EXPECT_EQ(result.frames_bad + result.frames_lost + result.receive_overruns, 0);
  EXPECT_GT(result.echoes, 4.0 * kSeconds);
  EXPECT_LE(result.worst_echo_error_us, 1.0);
  EXPECT_LE(jitter.us(), 10.0);
}

}  // namespace
}  // namespace echomap::tests

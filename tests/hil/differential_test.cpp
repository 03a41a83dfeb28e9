// SPDX-License-Identifier: MIT
#include "tests/hil/measure/differential.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::tests {
namespace {

/// The target of this name, if the build has it.
const DifferentialTarget* find_target(const std::vector<DifferentialTarget>& targets,
                                      const std::string& name) {
  const auto found = std::find_if(
      targets.begin(), targets.end(), [&](const auto& target) { return target.name() == name; });
  return found == targets.end() ? nullptr : &*found;
}

class Differential : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Targets, Differential, ::testing::Values("arm", "avr"));

/// Bench differential does it for ten million steps.
TEST_P(Differential, EveryOutputIsThatOfTheNativeFirmware) {
  const auto targets = DifferentialTarget::all();
  const DifferentialTarget* const native = find_target(targets, "native");
  const DifferentialTarget* const chip = find_target(targets, GetParam());
  ASSERT_NE(native, nullptr);
  if (chip == nullptr) {
    GTEST_SKIP() << GetParam() << ": apt install g++-arm-linux-gnueabi qemu-user";
  }
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    const auto step = first_difference(*native, *chip, {.seed = seed, .steps = 10'000});
    EXPECT_FALSE(step) << GetParam() << ", seed " << seed << ": other outputs from step "
                       << step.value_or(0) << " on";
  }
}

TEST(DifferentialReports, TellTwoWorldsApartInTheirFirstSteps) {
  const auto targets = DifferentialTarget::all();
  const DifferentialRequest first{.seed = 1, .steps = 100, .report_every = 1};
  const DifferentialRequest second{.seed = 2, .steps = 100, .report_every = 1};
  EXPECT_EQ(targets.front().run(first), targets.front().run(first));
  EXPECT_NE(targets.front().run(first).at(20), targets.front().run(second).at(20));
}

TEST(DifferentialReports, ComeOnlyFromTheStepAskedForOn) {
  const auto targets = DifferentialTarget::all();
  const auto all = targets.front().run({.steps = 1'000, .report_every = 10});
  const auto late = targets.front().run({.steps = 1'000, .report_every = 10, .report_from = 500});
  ASSERT_EQ(all.size(), 100U);
  ASSERT_EQ(late.size(), 51U);
  EXPECT_EQ(late.front(), all.at(49));
  EXPECT_EQ(late.back(), all.back());
}

}  // namespace
}  // namespace echomap::tests

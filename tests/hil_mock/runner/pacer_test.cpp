// SPDX-License-Identifier: MIT
#include "hil_mock/runner/pacer.hpp"

#include <chrono>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::runner {
namespace {

using std::chrono::milliseconds;

const Pacer::Moment begin{};

TEST(Pacer, SimulatedTimeIsDueAtItsSpeed) {
  Pacer pacer(4.0, begin);
  EXPECT_EQ(pacer.due_ns(begin, 0), 0);
  EXPECT_EQ(pacer.due_ns(begin + milliseconds(10), 0), 40'000'000);
  EXPECT_EQ(pacer.due_ns(begin + milliseconds(1000), 3'900'000'000), 4'000'000'000);
}

TEST(Pacer, ForgivesAMachineThatHasFallenFarBehind) {
  Pacer pacer(1.0, begin);
  EXPECT_EQ(pacer.due_ns(begin + milliseconds(10'000), 1'000), 1'000);
  EXPECT_EQ(pacer.due_ns(begin + milliseconds(10'020), 1'000), 20'001'000);
}

TEST(Pacer, WithoutASpeedEverythingIsDueAtOnce) {
  Pacer pacer(std::numeric_limits<double>::infinity(), begin);
  EXPECT_EQ(pacer.due_ns(begin, 0), std::numeric_limits<std::int64_t>::max());
}

TEST(Pacer, RefusesAStandstill) { EXPECT_THROW(Pacer(0.0, begin), std::invalid_argument); }

}  // namespace
}  // namespace echomap::runner

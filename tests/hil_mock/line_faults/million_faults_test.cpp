// SPDX-License-Identifier: MIT
#include <iostream>

#include <gtest/gtest.h>

#include "tests/hil_mock/line_faults/fault_stretches.hpp"

// A million faults, one at a time, in streams of every message; the table of docs/protocol.md.
namespace echomap::line_faults {
namespace {

constexpr int kFaultsOfAKind = 200'000;

class MillionFaults : public testing::TestWithParam<FaultKind> {};

TEST_P(MillionFaults, NoneMakesAFrameAndEveryLossIsCounted) {
  const FaultKind kind = GetParam();
  const FaultOutcome outcome = suffer_faults(kind, kFaultsOfAKind, 1);
  std::cout << "kind " << static_cast<int>(kind) << ": lost per fault " << outcome.lost_per_fault()
            << ", bad " << outcome.bad << ", wrong " << outcome.wrong << '\n';
  EXPECT_EQ(outcome.wrong, 0U);
  EXPECT_EQ(outcome.counted, outcome.lost);
  const bool is_of_one_byte = kind != FaultKind::kBurst && kind != FaultKind::kCut;
  EXPECT_LE(outcome.lost_per_fault(),
            is_of_one_byte              ? 1.10
            : kind == FaultKind::kBurst ? 2.0
                                        : 4.0);
}

INSTANTIATE_TEST_SUITE_P(Kinds,
                         MillionFaults,
                         testing::Values(FaultKind::kFlip,
                                         FaultKind::kDrop,
                                         FaultKind::kInsert,
                                         FaultKind::kBurst,
                                         FaultKind::kCut));

}  // namespace
}  // namespace echomap::line_faults

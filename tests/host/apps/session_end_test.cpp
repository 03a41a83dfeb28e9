// SPDX-License-Identifier: MIT
#include "host/apps/session_end.hpp"

#include <gtest/gtest.h>

namespace echomap::apps {
namespace {

using protocol::MotionOutcome;

TEST(SessionEnd, HasAnExitCodeOfItsOwn) {
  EXPECT_EQ(exit_code_of(SessionEnd::kInterrupted), ExitCode::kInterrupted);
  EXPECT_EQ(exit_code_of(SessionEnd::kLinkLost), ExitCode::kLinkLost);
  EXPECT_EQ(exit_code_of(SessionEnd::kSafetyStop), ExitCode::kSafetyStop);
  EXPECT_EQ(exit_code_of(SessionEnd::kFirmwareMismatch), ExitCode::kFirmwareMismatch);
  EXPECT_EQ(exit_code_of(SessionEnd::kConfigInvalid), ExitCode::kConfigInvalid);
}

TEST(SessionEnd, HasANameOfItsOwn) {
  EXPECT_EQ(outcome_of(SessionEnd::kInterrupted), "interrupted");
  EXPECT_EQ(outcome_of(SessionEnd::kLinkLost), "link-lost");
  EXPECT_EQ(outcome_of(SessionEnd::kSafetyStop), "safety-stop");
}

TEST(SessionEnd, ComesOfWhatDisarmsTheBoardAndOfNothingElse) {
  for (const auto outcome :
       {MotionOutcome::kLifted, MotionOutcome::kRunaway, MotionOutcome::kOverSpeed}) {
    EXPECT_FALSE(safety_stop(outcome).empty()) << static_cast<int>(outcome);
  }
  for (const auto outcome : {MotionOutcome::kReached,
                             MotionOutcome::kBumped,
                             MotionOutcome::kHazard,
                             MotionOutcome::kStalled,
                             MotionOutcome::kExpired}) {
    EXPECT_TRUE(safety_stop(outcome).empty()) << static_cast<int>(outcome);
  }
}

}  // namespace
}  // namespace echomap::apps

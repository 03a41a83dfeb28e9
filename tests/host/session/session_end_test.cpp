// SPDX-License-Identifier: MIT
#include "host/session/session_end.hpp"

#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"

namespace echomap::session {
namespace {

using protocol::MotionOutcome;

TEST(SessionEnd, HasAnExitCodeOfItsOwn) {
  EXPECT_EQ(exit_code_of(SessionEnd::kInterrupted), console::ExitCode::kInterrupted);
  EXPECT_EQ(exit_code_of(SessionEnd::kLinkLost), console::ExitCode::kLinkLost);
  EXPECT_EQ(exit_code_of(SessionEnd::kSafetyStop), console::ExitCode::kSafetyStop);
  EXPECT_EQ(exit_code_of(SessionEnd::kFirmwareMismatch), console::ExitCode::kFirmwareMismatch);
  EXPECT_EQ(exit_code_of(SessionEnd::kConfigInvalid), console::ExitCode::kConfigInvalid);
  EXPECT_EQ(exit_code_of(SessionEnd::kTakenOver), console::ExitCode::kNoRobot);
}

TEST(SessionEnd, HasANameOfItsOwn) {
  EXPECT_EQ(outcome_of(SessionEnd::kInterrupted), "interrupted");
  EXPECT_EQ(outcome_of(SessionEnd::kLinkLost), "link-lost");
  EXPECT_EQ(outcome_of(SessionEnd::kSafetyStop), "safety-stop");
  EXPECT_EQ(outcome_of(SessionEnd::kTakenOver), "taken-over");
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
}  // namespace echomap::session

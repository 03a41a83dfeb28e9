// SPDX-License-Identifier: MIT
#include "host/tracking/strategy_drive.hpp"

#include <deque>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "tests/host/session/session_on_a_cable.hpp"

namespace echomap::tracking {
namespace {

using exploration::BeginScan;
using exploration::EndScan;
using exploration::FinishReason;
using exploration::Roll;
using exploration::Stand;

/// Asks for these motions, and is complete then.
class Listed final : public exploration::Explorer {
 public:
  explicit Listed(std::deque<exploration::Motion> motions) : motions_(std::move(motions)) {}

  exploration::Motion next(const pipeline::Snapshot& /*snapshot*/,
                           exploration::MotionResult /*last*/) override {
    if (motions_.empty()) {
      return exploration::Finished{FinishReason::kComplete};
    }
    const auto motion = motions_.front();
    motions_.pop_front();
    return motion;
  }

 private:
  std::deque<exploration::Motion> motions_;
};

class StrategyDriveTest : public session::SessionOnACable {
 protected:
  StrategyDriveTest() : robot(profile, session::Seed(3)) {
    robot.open({new_connection(), nullptr});
    robot.connect();
  }
  std::unique_ptr<StrategyDrive> drive(std::deque<exploration::Motion> motions) {
    return std::make_unique<StrategyDrive>(robot, [this, motions = std::move(motions)] {
      ++made;
      return std::make_unique<Listed>(motions);
    });
  }

  int made = 0;
  session::RobotContext robot;
};

TEST_F(StrategyDriveTest, EndsAStretchWithAScanAndSaysWhenTheStrategyIsOver) {
  const auto listed = drive({Stand{0.1}, BeginScan{}, EndScan{}, Stand{0.1}});
  EXPECT_TRUE(listed->go_to_next_stop());
  EXPECT_FALSE(listed->finished());
  EXPECT_FALSE(listed->go_to_next_stop());
  EXPECT_EQ(listed->finished(), FinishReason::kComplete);
}

TEST_F(StrategyDriveTest, BeginsItsStrategyAgainInANewMap) {
  const auto listed = drive({BeginScan{}, EndScan{}});
  EXPECT_TRUE(listed->go_to_next_stop());
  EXPECT_EQ(made, 1);
  listed->begin_new_map(0);
  EXPECT_EQ(made, 2);
  EXPECT_TRUE(listed->go_to_next_stop()) << "from its beginning";
}

}  // namespace
}  // namespace echomap::tracking

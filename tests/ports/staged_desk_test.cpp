// SPDX-License-Identifier: MIT
#include "tests/ports/staged_desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Nothing that is no robot notices anything.
class Desk : public testing::Test {
 protected:
  ~Desk() override {
    EXPECT_EQ(desk.strangers_bytes(), 0U);
    EXPECT_EQ(desk.strangers_openings(), 0);
    EXPECT_TRUE(desk.are_lines_as_before());
  }

  StagedDesk desk;
};

TEST_F(Desk, IsListedWhereNobodyCanBeAsked) {
  EXPECT_THAT(desk.connect(),
              AllOf(HasSubstr("1  /dev/ttyACM1: Arduino Uno R3 (2341:0043), in use"),
                    HasSubstr("2  /dev/ttyUSB0: CH340"),
                    HasSubstr("4  /dev/ttyUSB3: FTDI"),
                    Not(HasSubstr("HUAWEI")),
                    Not(HasSubstr("1d50"))));
  EXPECT_EQ(desk.robot_bytes(), 0U);
}

TEST_F(Desk, IsWrittenToWhereThePersonSays) {
  desk.set_answers({"2"});
  EXPECT_EQ(desk.connect(), StagedDesk::kRobot);
  EXPECT_GT(desk.robot_bytes(), 0U);
}

TEST_F(Desk, IsLeftAloneButForTheRobotThatHasAnsweredBefore) {
  desk.set_known({StagedDesk::kRobot, StagedDesk::kRunningRobot});
  EXPECT_EQ(desk.connect(), StagedDesk::kRobot);
}

TEST_F(Desk, HasNoRobotThatIsTakenForTheOneThatWasUnplugged) {
  desk.set_known({StagedDesk::kRobot, StagedDesk::kRunningRobot});
  desk.unplug_robot();
  EXPECT_THAT(desk.connect(), HasSubstr("next: name one"));
}

TEST(DeskWithARunningRobot, RefusesItWithTheProcessThatDrivesIt) {
  StagedDesk desk;
  EXPECT_THAT(desk.connect({StagedDesk::kRunningRobot}), HasSubstr("holds it"));
  EXPECT_EQ(desk.strangers_bytes(), 0U);
  EXPECT_TRUE(desk.are_lines_as_before());
}

TEST(DeskFigures, HaveNoByteToStrangers) { EXPECT_EQ(measure_strangers_bytes(), 0U); }

}  // namespace
}  // namespace echomap::tests

// SPDX-License-Identifier: MIT
#include "host/diagnosis/encoder_check.hpp"

#include <gtest/gtest.h>

namespace echomap::diagnosis {
namespace {

/// A robot of 1000 counts a metre, whose two wheels roll alike.
class EncoderCheckTest : public testing::Test {
 protected:
  /// A second in which both wheels roll so many counts and the encoders have so many errors.
  void roll(double counts, std::int64_t left_errors, std::int64_t right_errors) {
    const time::RobotTime stamp(std::chrono::seconds(++seconds_));
    travel_m_ += counts * geometry_.metres_per_tick();
    left_ += left_errors;
    right_ += right_errors;
    check.on_odometry({stamp, {travel_m_, travel_m_}});
    check.on_encoder_errors({stamp, left_, right_});
  }
  void roll_for(int seconds, double counts, std::int64_t left_errors, std::int64_t right_errors) {
    for (int i = 0; i < seconds; ++i) {
      roll(counts, left_errors, right_errors);
    }
  }

 private:
  sensors::RobotGeometry geometry_;
  int seconds_ = 0;
  double travel_m_ = 0.0;
  std::int64_t left_ = 0;
  std::int64_t right_ = 0;

 public:
  EncoderCheck check{geometry_};
};

TEST_F(EncoderCheckTest, SaysNothingOfCleanEncodersAndOfASparkNowAndThen) {
  roll_for(60, 1000.0, 0, 0);
  EXPECT_FALSE(check.fault());
  roll_for(600, 1000.0, 0, 1);
  EXPECT_FALSE(check.fault()) << "two counts in a thousand";
}

TEST_F(EncoderCheckTest, NamesTheWheelThatLosesCountsAndHowMany) {
  roll_for(3, 1000.0, 0, 0);
  roll_for(4, 980.0, 0, 10);
  ASSERT_TRUE(check.fault());
  EXPECT_EQ(check.fault()->kind, FaultKind::kRightDirty);
  EXPECT_GE(check.fault()->value, 0.005);
  EXPECT_LT(check.fault()->value, 0.021);
}

TEST_F(EncoderCheckTest, KeepsTheFirstThatItHasFound) {
  roll_for(3, 900.0, 50, 0);
  roll_for(20, 900.0, 0, 100);
  EXPECT_EQ(check.fault()->kind, FaultKind::kLeftDirty);
}

TEST_F(EncoderCheckTest, CountsAtRestWithoutTurningAreNoiseToo) {
  roll_for(12, 0.0, 2, 0);
  ASSERT_TRUE(check.fault());
  EXPECT_EQ(check.fault()->value, 1.0);
}

TEST_F(EncoderCheckTest, ForgetsWhatWasLongAgo) {
  roll(100.0, 0, 0);
  roll(100.0, 9, 0);
  roll_for(20, 100.0, 0, 0);
  roll(100.0, 9, 0);
  EXPECT_FALSE(check.fault());
}

TEST(EncoderDirt, ExplainsWheelsThatSeemToBeOfAnotherSize) {
  const Fault dirt{FaultKind::kLeftDirty, 0.05};
  EXPECT_TRUE(explains(dirt, FaultKind::kNone));
  EXPECT_TRUE(explains(dirt, FaultKind::kLeftWheelSize));
  EXPECT_TRUE(explains(dirt, FaultKind::kLeftStands));
  EXPECT_FALSE(explains(dirt, FaultKind::kRightStands));
  EXPECT_FALSE(explains(dirt, FaultKind::kPanReversed));
}

}  // namespace
}  // namespace echomap::diagnosis

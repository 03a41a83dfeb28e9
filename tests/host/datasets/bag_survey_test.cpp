// SPDX-License-Identifier: MIT
#include "host/datasets/bag_survey.hpp"

#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/ros_messages/std_msgs.hpp"
#include "tests/support/bag_writer.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::datasets {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using tests::ros_odometry;
using tests::ros_range;
using tests::ros_transform;

class BagSurveyTest : public testing::Test {
 protected:
  BagSurvey survey() {
    bag_.finish();
    return survey_bag(path_);
  }
  std::string survey_error() {
    return tests::thrown_text<files::FileError>([this] { survey(); });
  }

  tests::ScratchFolder folder_;
  std::filesystem::path path_ = folder_ / "drive.mcap";
  tests::BagWriter bag_{path_};
};

TEST_F(BagSurveyTest, UsesTheFirstOdometryAndTheFirstLaserAndNotesTheOthers) {
  bag_.write("/wheels", ros_odometry(1.0, {}), 1.0);
  bag_.write("/fused", ros_odometry(1.0, {}), 1.1);
  ros_messages::LaserScan sweep;
  sweep.header = tests::ros_header(1.0, "base_link");
  bag_.write("/front", sweep, 1.2);
  bag_.write("/rear", sweep, 1.3);
  bag_.write("/fused", ros_odometry(1.1, {}), 1.4);
  const BagSurvey found = survey();
  EXPECT_EQ(found.odometry_topic, "/wheels");
  EXPECT_EQ(found.laser_topic, "/front");
  EXPECT_EQ(found.base_frame, "base_link");
  EXPECT_THAT(found.notes,
              ElementsAre("/fused is ignored: the odometry is that of /wheels",
                          "/rear is ignored: the laser is that of /front"));
}

TEST_F(BagSurveyTest, TheRobotIsTheChildOfItsOdometry) {
  ros_messages::Odometry odometry = ros_odometry(1.0, {});
  odometry.child_frame_id = "/robot1/base";
  bag_.write("/odom", odometry, 1.0);
  EXPECT_EQ(survey().base_frame, "robot1/base");
}

TEST_F(BagSurveyTest, WithoutOdometryTheRobotIsWhatTheTransformFromOdomLeadsTo) {
  bag_.write("/tf", ros_transform(1.0, "odom", "base_footprint", {}), 1.0);
  bag_.write("/tf_static", ros_transform(1.0, "base_footprint", "base_link", {}), 1.0);
  const BagSurvey found = survey();
  EXPECT_EQ(found.odometry_topic, "");
  EXPECT_EQ(found.base_frame, "base_footprint");
  EXPECT_TRUE(found.static_transforms.has("base_link"));
  EXPECT_FALSE(found.static_transforms.has("base_footprint"));
}

TEST_F(BagSurveyTest, FindsSensorsByTransformsThatComeLater) {
  bag_.write("/sonar", ros_range(1.0, "sonar_link", 1.0), 1.0);
  bag_.write("/tf_static", ros_transform(0.0, "base_link", "sonar_link", {0.1, 0.0, 0.0}), 9.0);
  const BagSurvey found = survey();
  const auto T_robot_sonar = found.find_sensor(found.static_transforms, "sonar_link", 1.0);
  ASSERT_TRUE(T_robot_sonar);
  EXPECT_EQ(T_robot_sonar->position_m.x(), 0.1);
  EXPECT_THAT(found.notes, IsEmpty());
}

TEST_F(BagSurveyTest, ASensorWithoutATransformIsAnErrorThatSaysWhatToRecord) {
  bag_.write("/odom", ros_odometry(1.0, {}), 1.0);
  bag_.write("/sonar", ros_range(1.0, "sonar_link", 1.0), 1.0);
  EXPECT_THAT(survey_error(),
              AllOf(HasSubstr("drive.mcap: /sonar: no transform leads from base_link to its frame "
                              "sonar_link"),
                    HasSubstr("next: record /tf_static too")));
}

TEST_F(BagSurveyTest, ASensorInTheFrameOfTheRobotNeedsNoTransform) {
  bag_.write("/sonar", ros_range(1.0, "base_footprint", 1.0), 1.0);
  bag_.write("/other", ros_range(1.0, "/base_link", 1.0), 1.0);
  EXPECT_THAT(survey().notes, IsEmpty());
}

TEST_F(BagSurveyTest, ASensorWithoutAFrameIsNoted) {
  bag_.write("/sonar", ros_range(1.0, "", 1.0), 1.0);
  EXPECT_THAT(survey().notes,
              ElementsAre("/sonar names no frame: it is taken to be at the robot's origin"));
}

TEST_F(BagSurveyTest, ASensorThatLooksDownIsNotUsed) {
  bag_.write("/cliff", ros_range(1.0, "cliff_link", 1.0), 1.0);
  auto transform = ros_transform(0.0, "base_link", "cliff_link", {});
  transform.transforms[0].transform.rotation = {0.0, std::sqrt(0.5), 0.0, std::sqrt(0.5)};
  bag_.write("/tf_static", transform, 1.0);
  const BagSurvey found = survey();
  EXPECT_THAT(found.unused, ElementsAre("/cliff"));
  EXPECT_THAT(found.notes, ElementsAre("/cliff is ignored: its beams look up or down"));
}

TEST_F(BagSurveyTest, ABagOfNothingThatIsReadListsWhatItHas) {
  bag_.write("/chat", ros_messages::String{"hello"}, 1.0);
  bag_.write("/where", ros_messages::Pose{}, 1.0);
  EXPECT_THAT(survey_error(),
              AllOf(HasSubstr("has no ranges, laser scans, odometry or transforms; it has"),
                    HasSubstr("\n  /chat of std_msgs/msg/String"),
                    HasSubstr("\n  /where of geometry_msgs/msg/Pose")));
}

TEST_F(BagSurveyTest, AnEmptyBagIsAnError) {
  EXPECT_THAT(survey_error(), HasSubstr("it is empty"));
}

TEST_F(BagSurveyTest, AnotherEncodingIsAnError) {
  bag_.write_bytes("/scan", "sensor_msgs/LaserScan", {}, 1.0, "ros1");
  EXPECT_THAT(survey_error(),
              AllOf(HasSubstr("/scan is encoded as 'ros1', not as cdr"),
                    HasSubstr("next: convert the bag")));
}

TEST_F(BagSurveyTest, OtherTypesMayHaveAnyEncoding) {
  bag_.write_bytes("/chat", "chat", {}, 1.0, "json");
  bag_.write("/odom", ros_odometry(1.0, {}), 1.0);
  EXPECT_EQ(survey().odometry_topic, "/odom");
}

TEST_F(BagSurveyTest, DamageIsLeftToWhoReadsTheRecords) {
  const std::vector<std::uint8_t> half(10, 0);
  bag_.write("/odom", ros_odometry(1.0, {}), 1.0);
  bag_.write_bytes("/odom", std::string(ros_messages::Odometry::kName), half, 1.1);
  EXPECT_EQ(survey().odometry_topic, "/odom");
}

TEST_F(BagSurveyTest, TransformsThatAreNoRotationsAreLeftOut) {
  TransformTree tree;
  auto transform = ros_transform(0.0, "base_link", "camera", {});
  transform.transforms[0].transform.rotation.w = 0.0;
  add_transforms("/tf", transform, tree);
  EXPECT_FALSE(tree.has("camera"));
}

}  // namespace
}  // namespace echomap::datasets

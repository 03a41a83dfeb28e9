// SPDX-License-Identifier: MIT
#include "host/fleet/robot_knowledge.hpp"

#include <random>

#include <gtest/gtest.h>

#include "tests/host/fleet/fleet_of_robots.hpp"

namespace echomap::fleet {
namespace {

using fleet_messages::content_hash;

constexpr double kGoneAfterS = 16.0;

class RobotKnowledgeTest : public testing::Test {
 protected:
  void add(std::uint32_t index, const std::string& name, std::uint16_t map_number = 0) {
    const auto message =
        fleet_messages::to_message(random_submap(random_, index), map_number).value();
    knowledge_.take(message, content_hash(name), 0.0);
  }
  void set_graph(std::size_t poses) {
    const std::vector<geometry::Pose2> T_map_submaps(poses);
    knowledge_.take(
        fleet_messages::to_graph_message(T_map_submaps, Eigen::Matrix3d::Zero(), 0).value(),
        {},
        0.0);
  }
  void publish_pose(const geometry::Pose2& T_map_robot,
                    std::uint64_t stamp_ms,
                    double received_s,
                    std::uint16_t map_number = 0) {
    fleet_messages::PoseMessage message =
        fleet_messages::to_message(fleet_messages::PoseEstimate{T_map_robot}, 0.0, map_number)
            .value();
    message.stamp_ms = stamp_ms;
    knowledge_.take(message, {}, received_s);
  }
  FleetRobot state() const { return knowledge_.state(1.0, kGoneAfterS); }
  std::size_t shown_submaps() const { return state().maps.at(0).record->submaps.size(); }

  std::mt19937 random_{1};
  RobotKnowledge knowledge_{"r1"};
};

TEST_F(RobotKnowledgeTest, ShowsSubmapsWithoutAGapAndWithAPose) {
  add(0, "a");
  add(2, "c");
  EXPECT_EQ(shown_submaps(), 0U) << "no graph yet";
  set_graph(3);
  EXPECT_EQ(shown_submaps(), 1U) << "the second one misses";
  add(1, "b");
  EXPECT_EQ(shown_submaps(), 3U);
  set_graph(2);
  EXPECT_EQ(shown_submaps(), 2U);
  EXPECT_EQ(state().maps[0].record->T_map_submaps.size(), 2U);
}

TEST_F(RobotKnowledgeTest, ChoosesOfTwoWithOneIndexTheSameWhateverCameFirst) {
  set_graph(1);
  add(0, "a");
  const auto first = state().maps[0].record->submaps[0].readings[0].range_m;
  add(0, "b");
  const auto second = state().maps[0].record->submaps[0].readings[0].range_m;
  const bool a_is_less = content_hash("a") < content_hash("b");
  EXPECT_EQ(first == second, a_is_less);
}

TEST_F(RobotKnowledgeTest, MakesARecordOnlyWhereSomethingHasChanged) {
  add(0, "a");
  set_graph(1);
  const auto record = state().maps[0].record;
  EXPECT_EQ(state().maps[0].record, record);
  set_graph(1);
  EXPECT_EQ(state().maps[0].record, record) << "the same graph once more";
  add(0, "b", 1);
  EXPECT_EQ(state().maps[0].record, record) << "another map";
}

TEST_F(RobotKnowledgeTest, DrivesAsFastAsFromItsLastPoseToThisOne) {
  publish_pose({1.0, 0.0, M_PI / 2.0}, 1000, 0.2);
  EXPECT_EQ(state().pose->speed_m_per_s, 0.0) << "one pose says nothing of it";
  publish_pose({1.0, -0.3, M_PI / 2.0}, 2500, 0.5);
  EXPECT_NEAR(state().pose->speed_m_per_s, -0.2, 1e-3) << "backwards";
  EXPECT_EQ(knowledge_.state(4.0, kGoneAfterS).pose->speed_m_per_s, 0.0)
      << "it would have told where it drives";
  publish_pose({1.0, 0.7, M_PI / 2.0}, 12500, 0.9);
  EXPECT_EQ(state().pose->speed_m_per_s, 0.0) << "nobody knows when it set out";
  publish_pose({1.0, 0.9, M_PI / 2.0}, 13500, 0.95, 1);
  EXPECT_EQ(state().pose->speed_m_per_s, 0.0) << "in another map";
}

TEST_F(RobotKnowledgeTest, IsGoneWithoutAMessageForAWhile) {
  EXPECT_EQ(knowledge_.attendance(0.0, kGoneAfterS), Attendance::kGone) << "never heard";
  knowledge_.set_first_seen(10.0);
  EXPECT_EQ(knowledge_.attendance(20.0, kGoneAfterS), Attendance::kAlive);
  EXPECT_EQ(knowledge_.attendance(27.0, kGoneAfterS), Attendance::kGone);
  knowledge_.set_first_seen(27.0);
  EXPECT_EQ(knowledge_.attendance(27.0, kGoneAfterS), Attendance::kGone) << "only kept";
  knowledge_.set_last_seen(28.0);
  EXPECT_EQ(knowledge_.attendance(28.0, kGoneAfterS), Attendance::kAlive);
  knowledge_.lose();
  EXPECT_EQ(knowledge_.attendance(28.0, kGoneAfterS), Attendance::kGone);
}

TEST_F(RobotKnowledgeTest, ForgetsWhatItSaidOfASearchBeforeItsHostStartedAgain) {
  knowledge_.note_boot(5);
  knowledge_.take(fleet_messages::to_message(fleet_messages::SearchReport{}, 0).value(), {}, 0.0);
  knowledge_.note_boot(5);
  EXPECT_TRUE(state().search);
  knowledge_.note_boot(6);
  EXPECT_FALSE(state().search);
}

TEST_F(RobotKnowledgeTest, KnowsWhatWasPromised) {
  knowledge_.take(
      fleet_messages::ManifestMessage{0, {content_hash("a"), content_hash("b")}}, {}, 0);
  knowledge_.take(fleet_messages::ManifestMessage{1, {content_hash("c")}}, {}, 0);
  EXPECT_EQ(knowledge_.promised().size(), 3U);
  EXPECT_TRUE(knowledge_.has_promised(content_hash("c")));
  EXPECT_FALSE(knowledge_.has_promised(content_hash("d")));
}

TEST_F(RobotKnowledgeTest, GivesTheTraitsOfItsPresenceToItsRecords) {
  add(0, "a");
  set_graph(1);
  EXPECT_EQ(state().maps[0].record->body_radius_m, 0.0);
  knowledge_.take(fleet_messages::with_traits({}, {0.13, 0.2}).value(), {}, 0.0);
  EXPECT_NEAR(state().maps[0].record->body_radius_m, 0.13, 1e-9);
}

}  // namespace
}  // namespace echomap::fleet

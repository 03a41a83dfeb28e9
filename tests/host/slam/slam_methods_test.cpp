// SPDX-License-Identifier: MIT
#include "host/slam/slam_methods.hpp"

#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/sensors/range_scan.hpp"

namespace echomap::slam {
namespace {

/// What a robot at `x_m` of a square room of 4 m sees with a laser all round.
sensors::RangeScan seen_from(double x_m) {
  constexpr int kBeams = 180;
  sensors::RangeScan scan;
  scan.max_range_m = 10.0;
  for (int i = 0; i < kBeams; ++i) {
    const double bearing_rad = (i - kBeams / 2) * 2.0 * std::numbers::pi / kBeams;
    const double along = std::cos(bearing_rad);
    const double aside = std::abs(std::sin(bearing_rad));
    const double to_wall_m = (along > 0.0 ? 2.0 - x_m : 2.0 + x_m) / std::abs(along);
    scan.beams.push_back({bearing_rad, std::min(to_wall_m, 2.0 / aside)});
  }
  return scan;
}

class EachSlam : public testing::TestWithParam<const NamedSlam*> {};

TEST_P(EachSlam, KeepsAPoseForEachScan) {
  const auto slam = GetParam()->make();
  constexpr int kScans = 80;
  for (int i = 0; i < kScans; ++i) {
    const double x_m = 0.02 * i;
    slam->add({x_m, 0.0, 0.0}, seen_from(x_m));
  }
  ASSERT_EQ(slam->trajectory().size(), std::size_t{kScans});
  EXPECT_NEAR(slam->trajectory().back().x_m(), 1.58, 0.05);
  EXPECT_NEAR(slam->belief().T_map_robot.x_m(), 1.58, 0.05);
}

TEST_P(EachSlam, GivesAGraphThatHangsOnItsFirstPose) {
  const auto slam = GetParam()->make();
  for (int i = 0; i < 80; ++i) {
    const double x_m = 0.02 * i;
    slam->add({x_m, 0.0, 0.0}, seen_from(x_m));
  }
  const FactorGraph graph = slam->factor_graph();
  ASSERT_GE(graph.T_map_nodes.size(), 2U);
  EXPECT_NEAR(graph.T_map_nodes.front().x_m(), 0.0, 1e-9);
  EXPECT_GT(graph.T_map_nodes.back().x_m(), 0.9);
  PoseGraph solved;
  for (const auto& node : graph.T_map_nodes) {
    solved.add_node(node);
  }
  for (const PoseEdge& edge : graph.edges) {
    EXPECT_FALSE(edge.is_doubtful);
    solved.add_edge(edge);
  }
  ASSERT_TRUE(solved.solve());
  for (std::size_t i = 0; i < graph.T_map_nodes.size(); ++i) {
    EXPECT_NEAR(solved.nodes()[i].x_m(), graph.T_map_nodes[i].x_m(), 0.01) << i;
  }
}

TEST_P(EachSlam, HasNothingBeforeTheFirstScan) {
  const auto slam = GetParam()->make();
  EXPECT_TRUE(slam->trajectory().empty());
  EXPECT_TRUE(slam->factor_graph().edges.empty());
}

TEST_P(EachSlam, StaysWithItsOdometryWhereNothingAnswers) {
  const auto slam = GetParam()->make();
  sensors::RangeScan silent = seen_from(0.0);
  for (sensors::Beam& beam : silent.beams) {
    beam.range_m.reset();
  }
  for (int i = 0; i < 40; ++i) {
    slam->add({0.05 * i, 0.0, 0.01 * i}, silent);
  }
  const auto last = slam->trajectory().back();
  EXPECT_NEAR(last.x_m(), 1.95, 1e-6);
  EXPECT_NEAR(last.heading_rad(), 0.39, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(All,
                         EachSlam,
                         testing::ValuesIn([] {
                           std::vector<const NamedSlam*> all;
                           for (const NamedSlam& one : slam_methods()) {
                             all.push_back(&one);
                           }
                           return all;
                         }()),
                         [](const auto& tested) { return std::string(tested.param->name); });

TEST(SlamMethods, AreAskedForByTheirNames) {
  EXPECT_FALSE(slam_by_name("scan").takes_cones);
  EXPECT_TRUE(slam_by_name("multiscan").takes_cones);
  EXPECT_EQ(slam_by_name(std::string("grid")).name, "multiscan") << "in summaries of old runs";
  EXPECT_TRUE(slam_by_name("ekf").takes_cones);
  EXPECT_THROW(slam_by_name("laser"), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam

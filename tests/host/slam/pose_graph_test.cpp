// SPDX-License-Identifier: MIT
#include "host/slam/pose_graph.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;

Pose2 random_pose(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-3.0, 3.0);
  return {any(random), any(random), any(random)};
}

Pose2 pushed(const Pose2& pose, int by, double step) {
  Eigen::Vector3d values(pose.x_m(), pose.y_m(), pose.heading_rad());
  values[by] += step;
  return {values.x(), values.y(), values.z()};
}

Eigen::Vector3d difference(const Eigen::Vector3d& high, const Eigen::Vector3d& low) {
  return {high.x() - low.x(), high.y() - low.y(), geometry::wrap_angle(high.z() - low.z())};
}

TEST(EdgeError, HasTheDerivativesOfFiniteDifferences) {
  std::mt19937 random(3);
  constexpr double kStep = 1e-6;
  for (int trial = 0; trial < 50; ++trial) {
    const PoseEdge edge{0, 1, random_pose(random), Eigen::Matrix3d::Identity(), false};
    const Pose2 from = random_pose(random);
    const Pose2 to = random_pose(random);
    const EdgeError off = edge_error(edge, from, to);
    for (int by = 0; by < 3; ++by) {
      const Eigen::Vector3d by_from =
          difference(edge_error(edge, pushed(from, by, kStep), to).error,
                     edge_error(edge, pushed(from, by, -kStep), to).error) /
          (2.0 * kStep);
      const Eigen::Vector3d by_to =
          difference(edge_error(edge, from, pushed(to, by, kStep)).error,
                     edge_error(edge, from, pushed(to, by, -kStep)).error) /
          (2.0 * kStep);
      EXPECT_LT((off.by_from.col(by) - by_from).norm(), 1e-7) << trial << ' ' << by;
      EXPECT_LT((off.by_to.col(by) - by_to).norm(), 1e-7) << trial << ' ' << by;
    }
  }
}

TEST(EdgeError, IsNoneWhereThePosesAreAsTheEdgeSays) {
  std::mt19937 random(4);
  const Pose2 from = random_pose(random);
  const Pose2 T_from_to = random_pose(random);
  const PoseEdge edge{0, 1, T_from_to, Eigen::Matrix3d::Identity(), false};
  EXPECT_LT(edge_error(edge, from, from * T_from_to).error.norm(), 1e-12);
}

/// A square of 4 m with one node each metre, drawn by odometry that turns 2 degrees too far in
/// each corner.
struct Square {
  PoseGraph graph;
  std::vector<Pose2> truth;

  Square() {
    Pose2 drawn;
    Pose2 now;
    graph.add_node(drawn);
    truth.push_back(now);
    for (int i = 1; i < 16; ++i) {
      const bool is_corner = i % 4 == 0;
      const Pose2 step(1.0, 0.0, is_corner ? std::numbers::pi / 2 : 0.0);
      const Pose2 told(1.0, 0.0, is_corner ? std::numbers::pi / 2 + 0.035 : 0.0);
      now = now * step;
      drawn = drawn * told;
      truth.push_back(now);
      const std::size_t node = graph.add_node(drawn);
      graph.add_edge({node - 1, node, told, information(0.02, 0.03), false});
    }
  }
  static Eigen::Matrix3d information(double stddev_m, double stddev_rad) {
    return Eigen::Vector3d(1.0 / (stddev_m * stddev_m),
                           1.0 / (stddev_m * stddev_m),
                           1.0 / (stddev_rad * stddev_rad))
        .asDiagonal();
  }
  double worst_m() const {
    double worst = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      worst = std::max(worst, (graph.nodes()[i].position_m() - truth[i].position_m()).norm());
    }
    return worst;
  }
};

TEST(PoseGraph, AClosedLoopPutsThePosesRight) {
  Square square;
  const double before_m = square.worst_m();
  const Pose2 T_last_first(1.0, 0.0, std::numbers::pi / 2);
  square.graph.add_edge({15, 0, T_last_first, Square::information(0.01, 0.005), true});
  ASSERT_TRUE(square.graph.solve());
  EXPECT_LT(square.worst_m(), 0.35 * before_m);
  EXPECT_LT(square.graph.square_error(square.graph.edges().back()), 1.0);
  EXPECT_EQ(square.graph.nodes()[0].position_m(), Eigen::Vector2d::Zero()) << "the first stays";
}

TEST(PoseGraph, ADoubtfulEdgeThatIsWrongBarelyPulls) {
  Square square;
  const Pose2 T_last_first(1.0, 0.0, std::numbers::pi / 2);
  square.graph.add_edge({15, 0, T_last_first, Square::information(0.01, 0.005), true});
  square.graph.solve();
  const double right_m = square.worst_m();
  square.graph.add_edge({2, 10, Pose2(), Square::information(0.01, 0.005), true});
  ASSERT_TRUE(square.graph.solve());
  EXPECT_NEAR(square.worst_m(), right_m, 0.01);
}

TEST(PoseGraph, WeighedEdgesHoldTheNodesWithoutDoubt) {
  Square square;
  const Pose2 T_last_first(1.0, 0.0, std::numbers::pi / 2);
  square.graph.add_edge({15, 0, T_last_first, Square::information(0.01, 0.005), true});
  square.graph.add_edge({2, 10, {0.5, 0.0, 0.0}, Square::information(0.5, 0.3), true});
  ASSERT_TRUE(square.graph.solve());
  const auto weighed = square.graph.weighed_edges();
  EXPECT_EQ(weighed.front().information, square.graph.edges().front().information);
  EXPECT_LT(weighed.back().information(0, 0), 0.9 * square.graph.edges().back().information(0, 0));
  PoseGraph without_doubt;
  for (const Pose2& node : square.graph.nodes()) {
    without_doubt.add_node(node);
  }
  for (const PoseEdge& edge : weighed) {
    EXPECT_FALSE(edge.is_doubtful);
    without_doubt.add_edge(edge);
  }
  ASSERT_TRUE(without_doubt.solve());
  for (std::size_t i = 0; i < weighed.size() - 1; ++i) {
    const Eigen::Vector2d moved_m =
        without_doubt.nodes()[i].position_m() - square.graph.nodes()[i].position_m();
    EXPECT_LT(moved_m.norm(), 1e-3) << i;
  }
}

TEST(PoseGraph, SaysWhereANodeHangsOnNothing) {
  PoseGraph graph;
  graph.add_node({});
  graph.add_node({1.0, 0.0, 0.0});
  EXPECT_FALSE(graph.solve());
  EXPECT_EQ(graph.nodes()[1].x_m(), 1.0);
}

TEST(PoseGraph, RefusesEdgesToNodesThatAreNotThere) {
  PoseGraph graph;
  graph.add_node({});
  EXPECT_THROW(graph.add_edge({0, 1, {}, Eigen::Matrix3d::Identity(), false}),
               std::invalid_argument);
  EXPECT_THROW(graph.add_edge({0, 0, {}, Eigen::Matrix3d::Identity(), false}),
               std::invalid_argument);
  EXPECT_THROW(PoseGraph({0, 1e-4, 1e-4, 5.0}), std::invalid_argument);
}

TEST(Information, TurnsWithThePose) {
  const Eigen::Matrix3d along_map_x = Eigen::Vector3d(9.0, 1.0, 4.0).asDiagonal();
  const Eigen::Matrix3d own = in_frame_of({5.0, 6.0, std::numbers::pi / 2}, along_map_x);
  EXPECT_NEAR(own(0, 0), 1.0, 1e-12);
  EXPECT_NEAR(own(1, 1), 9.0, 1e-12);
  EXPECT_NEAR(own(2, 2), 4.0, 1e-12);
}

TEST(Information, IsLessWithASpreadAndNoneWhereItWasNone) {
  const Eigen::Matrix3d only_y = Eigen::Vector3d(0.0, 1e6, 100.0).asDiagonal();
  const Eigen::Matrix3d left = with_spread(only_y, 0.01, 0.1);
  EXPECT_NEAR(left(0, 0), 0.0, 1e-12);
  EXPECT_NEAR(left(1, 1), 1.0 / (1e-6 + 1e-4), 1e-6);
  EXPECT_NEAR(left(2, 2), 1.0 / (0.01 + 0.01), 1e-9);
}

}  // namespace
}  // namespace echomap::slam

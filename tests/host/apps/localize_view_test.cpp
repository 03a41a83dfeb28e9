// SPDX-License-Identifier: MIT
#include "host/apps/localize_view.hpp"

#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/apps/explore_run.hpp"
#include "host/pipeline/observation_fork.hpp"
#include "tests/host/session/session_on_a_cable.hpp"

namespace echomap::apps {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<geometry::Pose2> spread_poses(double stddev_x_m) {
  std::mt19937 random(1);
  std::normal_distribution<double> x(1.0, stddev_x_m);
  std::normal_distribution<double> y(-2.0, 0.01);
  std::normal_distribution<double> heading(kPi, 0.1);
  std::vector<geometry::Pose2> poses;
  for (int i = 0; i < 500; ++i) {
    poses.emplace_back(x(random), y(random), heading(random));
  }
  return poses;
}

TEST(AgreedPose, IsTheMeanWithTheWidestSpread) {
  const auto agreed = agreed_pose(spread_poses(0.05));
  ASSERT_TRUE(agreed);
  EXPECT_NEAR(agreed->T_map_robot.x_m(), 1.0, 0.01);
  EXPECT_NEAR(agreed->T_map_robot.y_m(), -2.0, 0.01);
  EXPECT_NEAR(std::abs(agreed->T_map_robot.heading_rad()), kPi, 0.02) << "across the seam";
  EXPECT_NEAR(agreed->position_95_m, 0.098, 0.01);
}

TEST(AgreedPose, IsNoneWhereTheParticlesDisagree) {
  EXPECT_FALSE(agreed_pose(spread_poses(1.0)));
  EXPECT_FALSE(agreed_pose({}));
  EXPECT_FALSE(agreed_pose({geometry::Pose2()}));
}

class SpreadFilter final : public tracking::LiveFilter {
 public:
  pipeline::ObservationSink& sink() override { return sink_; }
  void poll(const session::RobotSession& /*session*/) override {}
  void begin(session::RobotSession& /*session*/) override {}
  bool has_lost_it() override { return false; }
  double telling(const geometry::Pose2& /*goal*/) const override { return 0.0; }
  std::optional<localization::PoseGaussian> estimate() const override { return std::nullopt; }
  std::vector<geometry::Pose2> sampled_poses(std::size_t /*count*/) const override {
    return spread_poses(stddev_m);
  }
  std::string line() const override { return "somewhere"; }
  nlohmann::ordered_json report() const override { return {}; }
  const std::vector<pipeline::StampedPose>& trajectory() const override { return trajectory_; }

  double stddev_m = 0.05;

 private:
  pipeline::ObservationFork sink_;
  std::vector<pipeline::StampedPose> trajectory_{1};
};

class LocalizeViewOnACable : public session::SessionOnACable {
 protected:
  LocalizeViewOnACable() {
    begin_maps(robot, "", "none");
    robot.open({new_connection(), nullptr});
  }

  session::RobotContext robot{profile, session::Seed(1)};
  SpreadFilter filter;
  mapping::RasterMap map{40, 30, 0.1, {-1.0, -3.0}};
  LocalizeView shown{robot, filter, map};
};

TEST_F(LocalizeViewOnACable, ShowsParticlesAndTheRobotWhereTheyAgree) {
  const terminal_view::RunView view = shown.view();
  EXPECT_EQ(view.map.columns(), 40);
  EXPECT_EQ(view.marks.particles_m.size(), 500U);
  EXPECT_TRUE(view.marks.T_map_robot);
  EXPECT_TRUE(view.status.position_95_m);
  EXPECT_EQ(view.status.stops, 1U);
}

TEST_F(LocalizeViewOnACable, ShowsNoRobotWhereTheyDisagree) {
  filter.stddev_m = 1.0;
  const terminal_view::RunView view = shown.view();
  EXPECT_EQ(view.marks.particles_m.size(), 500U);
  EXPECT_FALSE(view.marks.T_map_robot);
  EXPECT_FALSE(view.status.T_map_robot);
}

}  // namespace
}  // namespace echomap::apps

// SPDX-License-Identifier: MIT
#include "tests/benchmarks/room_slam_figures.hpp"

#include <algorithm>
#include <memory>
#include <string>

#include "host/slam/multiscan_slam.hpp"
#include "tests/benchmarks/thread_clock.hpp"
#include "tests/support/median.hpp"
#include "tests/support/offline_exploration.hpp"

namespace echomap::bench {

namespace {

constexpr double kPingsPerS = 25.0;

struct Cost {
  std::size_t pings = 0;
  double sum_s = 0.0;
  double longest_s = 0.0;
};

/// Grid SLAM that adds to what it has cost.
class TimedSlam final : public slam::SlamMethod {
 public:
  explicit TimedSlam(Cost& cost) : cost_(&cost) {}

  void follow(const geometry::Pose2& T_odom_robot) override {
    cost_->sum_s += processor_seconds([&] { slam_.follow(T_odom_robot); });
  }
  void add(const geometry::Pose2& T_odom_robot, const slam::RangeScan& scan) override {
    const double took_s = processor_seconds([&] { slam_.add(T_odom_robot, scan); });
    ++cost_->pings;
    cost_->sum_s += took_s;
    cost_->longest_s = std::max(cost_->longest_s, took_s);
  }
  localization::PoseGaussian belief() const override { return slam_.belief(); }
  std::vector<geometry::Pose2> trajectory() const override { return slam_.trajectory(); }
  mapping::OccupancyGrid grid() const override { return slam_.grid(); }
  slam::FactorGraph factor_graph() const override { return slam_.factor_graph(); }

 private:
  Cost* cost_;
  slam::MultiscanSlam slam_;
};

world::RobotParams with_rough_odometry(world::RobotParams robot) {
  robot.drive.wheel_diameter_sd = 0.03;
  robot.drive.wheel_mismatch_sd = 0.01;
  robot.drive.track_sd = 0.03;
  robot.drive.slip_m_per_sqrt_m = 0.003;
  return robot;
}

/// The runs of one room, a value a seed.
struct RoomRuns {
  std::vector<double> ate_ratios;
  std::vector<double> heading_ratios;
  std::vector<double> odometry_ate_m;
  std::vector<double> free_ious;

  void add(const tests::OfflineRun& run) {
    ate_ratios.push_back(run.trajectory.ate_rmse_m / run.odometry.ate_rmse_m);
    heading_ratios.push_back(run.trajectory.ate_heading_rmse_rad /
                             run.odometry.ate_heading_rmse_rad);
    odometry_ate_m.push_back(run.odometry.ate_rmse_m);
    free_ious.push_back(run.agreement.free_iou);
  }
};

void add_figures(const std::string& room, const RoomRuns& runs, std::vector<Figure>& figures) {
  constexpr double kHarm = 1.05;
  const auto count = runs.ate_ratios.size();
  const auto harmed = std::count_if(
      runs.ate_ratios.begin(), runs.ate_ratios.end(), [](double ratio) { return ratio > kHarm; });
  const double worst = *std::max_element(runs.ate_ratios.begin(), runs.ate_ratios.end());
  figures.push_back({room + "_odometry_ate_m", tests::median(runs.odometry_ate_m), "m", count, {}});
  figures.push_back({room + "_ate_ratio", tests::median(runs.ate_ratios), "", count, {}});
  figures.push_back({room + "_ate_ratio_worst", worst, "", count, {}});
  figures.push_back({room + "_harmed_runs", static_cast<double>(harmed), "", count, {}});
  figures.push_back({room + "_heading_ratio", tests::median(runs.heading_ratios), "", count, {}});
  figures.push_back({room + "_free_iou", tests::median(runs.free_ious), "", count, {}});
}

RoomRuns explore_room(const std::string& room,
                      const world::RobotParams& robot,
                      std::uint32_t seeds,
                      Cost& cost) {
  tests::OfflineSettings settings;
  settings.slam = [&cost] { return std::make_unique<TimedSlam>(cost); };
  RoomRuns runs;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    runs.add(tests::explore_offline(tests::bundled_room(room), robot, seed, settings));
  }
  return runs;
}

}  // namespace

std::vector<Figure> room_slam_figures(std::uint32_t seeds) {
  const world::RobotParams fine = tests::bundled_robot("uno_2wd");
  std::vector<Figure> figures;
  Cost cost;
  for (const std::string room : {"living_room", "office", "corridor"}) {
    add_figures(room, explore_room(room, with_rough_odometry(fine), seeds, cost), figures);
    add_figures(room + "_fine", explore_room(room, fine, seeds, cost), figures);
  }
  const double sensing_s = static_cast<double>(cost.pings) / kPingsPerS;
  figures.push_back({"sonar_cpu_percent", 100.0 * cost.sum_s / sensing_s, "%", cost.pings, {}});
  figures.push_back({"sonar_longest_ms", 1e3 * cost.longest_s, "ms", cost.pings, {}});
  return figures;
}

}  // namespace echomap::bench

// SPDX-License-Identifier: MIT
#include "tests/benchmarks/room_slam_figures.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "host/sensors/range_scan.hpp"
#include "host/slam/slam_methods.hpp"
#include "tests/benchmarks/slam_run_figures.hpp"
#include "tests/benchmarks/thread_clock.hpp"
#include "tests/support/offline_exploration.hpp"

namespace echomap::bench {

namespace {

constexpr double kPingsPerS = 25.0;

struct Cost {
  std::size_t pings = 0;
  double sum_s = 0.0;
  double longest_s = 0.0;
};

/// SLAM that adds to what it has cost.
class TimedSlam final : public slam::SlamMethod {
 public:
  TimedSlam(std::unique_ptr<slam::SlamMethod> method, Cost& cost)
      : cost_(&cost), method_(std::move(method)) {}

  void follow(const geometry::Pose2& T_odom_robot) override {
    cost_->sum_s += processor_seconds([&] { method_->follow(T_odom_robot); });
  }
  void add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan) override {
    const double took_s = processor_seconds([&] { method_->add(T_odom_robot, scan); });
    ++cost_->pings;
    cost_->sum_s += took_s;
    cost_->longest_s = std::max(cost_->longest_s, took_s);
  }
  localization::PoseGaussian belief() const override { return method_->belief(); }
  std::vector<geometry::Pose2> trajectory() const override { return method_->trajectory(); }
  slam::FactorGraph factor_graph() const override { return method_->factor_graph(); }

 private:
  Cost* cost_;
  std::unique_ptr<slam::SlamMethod> method_;
};

std::vector<SlamRun> explore_room(const std::string& room,
                                  const world::RobotParams& robot,
                                  std::uint32_t seeds,
                                  const tests::OfflineSettings& settings) {
  std::vector<SlamRun> runs;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    const auto run = tests::explore_offline(tests::bundled_room(room), robot, seed, settings);
    runs.push_back({run.trajectory, run.odometry, run.agreement.free_iou});
  }
  return runs;
}

}  // namespace

std::vector<Figure> room_slam_figures(const slam::NamedSlam& method, std::uint32_t seeds) {
  const world::RobotParams rough = tests::bundled_robot("uno_2wd_rough");
  const world::RobotParams fine = tests::bundled_robot("uno_2wd");
  std::vector<Figure> figures;
  Cost cost;
  tests::OfflineSettings settings;
  settings.slam = [&] { return std::make_unique<TimedSlam>(method.make(), cost); };
  const auto add = [&](const std::string& name, const std::vector<SlamRun>& runs) {
    const auto some = slam_run_figures(name, runs);
    figures.insert(figures.end(), some.begin(), some.end());
  };
  for (const std::string room : {"living_room", "office", "corridor"}) {
    add(room, explore_room(room, rough, seeds, settings));
    add(room + "_fine", explore_room(room, fine, seeds, settings));
  }
  const double sensing_s = static_cast<double>(cost.pings) / kPingsPerS;
  figures.push_back({"sonar_cpu_percent", 100.0 * cost.sum_s / sensing_s, "%", cost.pings, {}});
  figures.push_back({"sonar_longest_ms", 1e3 * cost.longest_s, "ms", cost.pings, {}});
  return figures;
}

}  // namespace echomap::bench

// SPDX-License-Identifier: MIT
// What must hold of the maps of real sonar logs, whose rooms nobody has measured.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/datasets/open_log.hpp"
#include "host/pipeline/log_player.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "tests/support/nearest_points.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::pipeline {
namespace {

using mapping::CellState;

struct SonarLogCase {
  const char* name;
  const char* path;
  const char* format;
  PoseSource poses;
  double max_range_m;
};

class SonarLog : public testing::TestWithParam<SonarLogCase> {
 protected:
  void SetUp() override {
    const auto path = tests::real_data(GetParam().path);
    ECHOMAP_SKIP_WITHOUT(path);
    RobotPipeline pipeline(sensors::RobotGeometry{});
    LogPlayer player(pipeline, GetParam().poses);
    const auto log = datasets::open_log(path, GetParam().format);
    while (const auto record = log->next()) {
      player.play(*record);
    }
    snapshot_ = pipeline.snapshot();
    const auto& bounds = grid().bounds();
    for (std::int32_t y = bounds.min.y; y <= bounds.max.y; ++y) {
      for (std::int32_t x = bounds.min.x; x <= bounds.max.x; ++x) {
        const CellState state = grid().state({x, y});
        if (state != CellState::kUnknown) {
          (state == CellState::kFree ? free_m_ : walls_m_).push_back(grid().center_m({x, y}));
        }
      }
    }
  }

  const mapping::OccupancyGrid& grid() const { return *snapshot_.grid; }
  std::vector<Eigen::Vector2d> path_m() const {
    std::vector<Eigen::Vector2d> path_m;
    for (const StampedPose& pose : *snapshot_.trajectory) {
      path_m.push_back(pose.T_map_robot.position_m());
    }
    return path_m;
  }

  Snapshot snapshot_;
  std::vector<Eigen::Vector2d> free_m_;
  std::vector<Eigen::Vector2d> walls_m_;
};

TEST_P(SonarLog, ClaimsNothingBeyondWhatTheSensorReaches) {
  constexpr double kArcM = 0.15;
  const tests::NearestPoints path(path_m());
  for (const auto* cells_m : {&free_m_, &walls_m_}) {
    for (const Eigen::Vector2d& cell_m : *cells_m) {
      ASSERT_LE(path.nearest(cell_m)->distance_m, GetParam().max_range_m + kArcM);
    }
  }
}

TEST_P(SonarLog, LeavesFloorFreeWhereTheRobotHasBeen) {
  const auto path = path_m();
  const auto in_walls = std::count_if(path.begin(), path.end(), [this](const auto& point_m) {
    return grid().state(grid().cell_at(point_m)) == CellState::kOccupied;
  });
  EXPECT_LE(static_cast<double>(in_walls), 0.002 * static_cast<double>(path.size()));
}

TEST_P(SonarLog, PutsWallsBesideFreeFloor) {
  ASSERT_FALSE(free_m_.empty());
  ASSERT_FALSE(walls_m_.empty());
  constexpr double kBesideM = 0.15;
  const tests::NearestPoints floor(free_m_);
  const auto beside = std::count_if(walls_m_.begin(), walls_m_.end(), [&](const auto& wall_m) {
    return floor.nearest(wall_m)->distance_m <= kBesideM;
  });
  EXPECT_GE(static_cast<double>(beside), 0.85 * static_cast<double>(walls_m_.size()));
}

TEST_P(SonarLog, HasFewWallsBesideItsFloor) {
  const auto walls = static_cast<double>(walls_m_.size());
  const auto floor = static_cast<double>(free_m_.size());
  EXPECT_GE(walls, 0.02 * floor);
  EXPECT_LE(walls, 0.25 * floor);
}

constexpr double kBigWheelBotM = 5.0;
const SonarLogCase kLogs[] = {
    {"Carl", "carl_gopigo3_panrange/20200705-092613.txt", "carl", PoseSource::kOdometry, 3.0},
    {"Udacity", "udacity_8sonar/measurement.txt", "udacity", PoseSource::kGiven, 5.11},
    {"GardenSmall",
     "bigwheelbot_hcsr04/Garden_small.txt",
     "bigwheelbot",
     PoseSource::kOdometry,
     kBigWheelBotM},
    {"Garden15March",
     "bigwheelbot_hcsr04/Garden_15_03_20.txt",
     "bigwheelbot",
     PoseSource::kOdometry,
     kBigWheelBotM},
    {"Garden27March",
     "bigwheelbot_hcsr04/Garden_27_03_20_3.txt",
     "bigwheelbot",
     PoseSource::kOdometry,
     kBigWheelBotM},
    {"Garden4April",
     "bigwheelbot_hcsr04/Garden_04_04_20.txt",
     "bigwheelbot",
     PoseSource::kOdometry,
     kBigWheelBotM},
    {"Garden10April",
     "bigwheelbot_hcsr04/Garden_10_04_20.txt",
     "bigwheelbot",
     PoseSource::kOdometry,
     kBigWheelBotM},
};

INSTANTIATE_TEST_SUITE_P(Real, SonarLog, testing::ValuesIn(kLogs), [](const auto& log) {
  return std::string(log.param.name);
});

}  // namespace
}  // namespace echomap::pipeline

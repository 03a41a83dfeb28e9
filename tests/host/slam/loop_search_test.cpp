// SPDX-License-Identifier: MIT
#include "host/slam/loop_search.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/sensors/range_scan.hpp"
#include "tests/host/slam/laser_building.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;

struct Search {
  tests::LaserBuilding building = tests::LaserBuilding::hall();
  std::mt19937 random{1};

  std::vector<Eigen::Vector2d> seen_m(const Pose2& from) {
    return sensors::end_points_m(building.scan(from, 180, random), 20.0);
  }
  std::vector<Eigen::Vector2d> map_m() {
    std::vector<Eigen::Vector2d> map_m;
    for (const Pose2& from : {Pose2(3.0, 3.0, 0.0), Pose2(3.0, 3.0, 3.0), Pose2(5.0, 4.0, 1.0)}) {
      const auto points_m = sensors::in_frame_a_m(from, seen_m(from));
      map_m.insert(map_m.end(), points_m.begin(), points_m.end());
    }
    return map_m;
  }
};

TEST(LoopSearch, FindsAPlaceMetresAway) {
  Search search;
  const Pose2 truth(4.0, 3.5, 0.3);
  const auto found =
      LoopSearch().find(search.map_m(), search.seen_m(truth), {{6.2, 1.9, 0.05}, 3.0, 0.4});
  ASSERT_TRUE(found);
  EXPECT_LT((found->T_map_robot.position_m() - truth.position_m()).norm(), 0.1);
  EXPECT_NEAR(found->T_map_robot.heading_rad(), truth.heading_rad(), 0.02);
  EXPECT_GT(found->score, 0.7);
}

TEST(LoopSearch, FindsTheBestOfAllOnTheLattice) {
  Search search;
  const auto map_m = search.map_m();
  const auto points_m = search.seen_m({4.0, 3.5, 0.3});
  const SearchWindow window{{4.3, 3.4, 0.25}, 0.6, 0.1};
  const auto branched = LoopSearch().find(map_m, points_m, window);
  LoopSearchParams plain;
  plain.levels = 1;
  const auto each = LoopSearch(plain).find(map_m, points_m, window);
  ASSERT_TRUE(branched && each);
  EXPECT_DOUBLE_EQ(branched->score, each->score);
}

TEST(LoopSearch, LooksEquallyFarToEachSide) {
  constexpr double kRadiusM = 0.8;
  Search search;
  const auto map_m = search.map_m();
  const Pose2 truth(4.0, 3.5, 0.3);
  const auto points_m = search.seen_m(truth);
  for (const Eigen::Vector2d& off_m :
       {Eigen::Vector2d(1.5, 0.0), {-1.5, 0.0}, {0.0, 1.5}, {0.0, -1.5}}) {
    const Eigen::Vector2d middle_m = truth.position_m() + off_m;
    LoopSearchParams any;
    any.min_score = 0.0;
    const auto found =
        LoopSearch(any).find(map_m, points_m, {{middle_m.x(), middle_m.y(), 0.3}, kRadiusM, 0.0});
    ASSERT_TRUE(found);
    const Eigen::Vector2d offset_m = found->T_map_robot.position_m() - middle_m;
    EXPECT_LE(offset_m.cwiseAbs().maxCoeff(), kRadiusM + 1e-9) << "from " << off_m.transpose();
  }
}

TEST(LoopSearch, FindsNothingWhereItHasNotBeen) {
  Search search;
  const auto map_m = search.map_m();
  search.building = tests::LaserBuilding::corridor();
  EXPECT_FALSE(
      LoopSearch().find(map_m, search.seen_m({0.0, 0.0, 0.0}), {{4.0, 3.5, 0.3}, 1.0, 0.2}));
  EXPECT_FALSE(LoopSearch().find({}, map_m, {{4.0, 3.5, 0.3}, 1.0, 0.2}));
  EXPECT_FALSE(LoopSearch().find(map_m, {}, {{4.0, 3.5, 0.3}, 1.0, 0.2}));
}

TEST(LoopSearch, RefusesParametersWithoutSense) {
  LoopSearchParams params;
  params.levels = 0;
  EXPECT_THROW(LoopSearch{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam

// SPDX-License-Identifier: MIT
#include "host/localization/place_search.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/localization/heard_scan.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/furnished_room.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;

/// 3.1 x 1.3 m, the same after half a turn.
mapping::RasterMap plain_room() {
  tests::DrawnMap drawing(28, "#" + std::string(62, '.') + "#");
  drawing.front() = drawing.back() = std::string(64, '#');
  return tests::map_from(drawing, 0.05);
}

struct Walk {
  explicit Walk(const mapping::RasterMap& map)
      : room(map), model(tests::sonar_model(map)), search(*model) {}

  void scan_from(const Pose2& T_map_robot) {
    search.add({T_odom_map * T_map_robot, tests::heard_scan(room, T_map_robot), {}});
  }

  mapping::RasterMap room;
  std::unique_ptr<ObservationModel> model;
  PlaceSearch search;
  Pose2 T_odom_map{-1.5, 0.7, 1.1};
};

TEST(PlaceSearch, FindsTheOnePlaceThatScansComeFrom) {
  Walk walk(tests::furnished_room());
  const Pose2 T_map_robot(2.2, 0.95, -0.3);
  walk.scan_from({1.5, 0.95, 0.4});
  walk.scan_from({1.9, 1.05, 0.0});
  walk.scan_from(T_map_robot);
  const auto places = walk.search.search(3);
  ASSERT_FALSE(places.empty());
  EXPECT_TRUE(walk.search.is_same_place(places.front().T_map_robot, T_map_robot));
  EXPECT_LT((places.front().T_map_robot.position_m() - T_map_robot.position_m()).norm(), 0.15);
  EXPECT_EQ(places.front().odds, 1.0);
  for (std::size_t i = 1; i < places.size(); ++i) {
    EXPECT_LT(places[i].odds, 0.05) << i;
  }
}

TEST(PlaceSearch, TellsBothEndsOfARoomThatLooksTheSameFromBoth) {
  Walk walk(plain_room());
  const Pose2 T_map_robot(0.7, 0.5, 0.3);
  walk.scan_from({1.1, 0.7, 0.0});
  walk.scan_from(T_map_robot);
  const Pose2 T_map_other(3.2 - 0.7, 1.4 - 0.5, 0.3 - std::numbers::pi);
  const auto places = walk.search.search(2);
  ASSERT_GE(places.size(), 2U);
  const auto is_told = [&](const Pose2& T_map_place) {
    return std::any_of(places.begin(), places.end(), [&](const FoundPlace& place) {
      return walk.search.is_same_place(place.T_map_robot, T_map_place) && place.odds > 0.1;
    });
  };
  EXPECT_TRUE(is_told(T_map_robot));
  EXPECT_TRUE(is_told(T_map_other));
}

TEST(PlaceSearch, ComparesThePlaceThatIsBelieved) {
  Walk walk(tests::furnished_room());
  walk.scan_from({2.2, 0.95, -0.3});
  const Pose2 T_map_believed(0.5, 0.3, 2.0);
  const auto places = walk.search.search(1, T_map_believed);
  EXPECT_EQ(
      std::count_if(
          places.begin(), places.end(), [](const FoundPlace& place) { return place.is_believed; }),
      1);
}

TEST(PlaceSearch, KnowsABelievedPlaceAlsoWhereABetterOneIsNear) {
  Walk walk(plain_room());
  walk.scan_from({1.1, 0.7, 0.0});
  for (const double off_m : {0.3, 0.45, 0.55, 0.6, 0.65}) {
    const auto places = walk.search.search(1, Pose2(1.1 + off_m, 0.7, 0.0));
    EXPECT_TRUE(std::any_of(places.begin(), places.end(), [](const FoundPlace& place) {
      return place.is_believed;
    })) << off_m;
  }
}

TEST(PlaceSearch, TakesTwoScansFromOneSpotForOne) {
  Walk walk(plain_room());
  walk.scan_from({1.1, 0.7, 0.0});
  walk.scan_from({1.1, 0.75, 1.5});
  EXPECT_EQ(walk.search.scans(), 1U);
}

TEST(PlaceSearch, ForgetsOldScans) {
  Walk walk(tests::furnished_room());
  for (int i = 0; i < 20; ++i) {
    walk.scan_from({0.3 + 0.12 * i, 1.05, 0.0});
  }
  EXPECT_EQ(walk.search.scans(), PlaceSearchParams().max_scans);
  walk.search.keep_newest(1);
  EXPECT_EQ(walk.search.scans(), 1U);
}

TEST(PlaceSearch, ForgetsTheWayToTheOldestScan) {
  const Pose2 T_map_robot(2.2, 0.95, -0.3);
  Walk walk(tests::furnished_room());
  walk.scan_from({1.5, 0.95, 0.4});
  const std::vector<RangeReading> of_elsewhere(20, {{0.0, 0.0, 1.0}, 0.05});
  walk.search.add(
      {walk.T_odom_map * T_map_robot, tests::heard_scan(walk.room, T_map_robot), of_elsewhere});
  const double with_way = walk.search.search(1).front().log_likelihood;
  walk.search.keep_newest(1);
  const double without_way = walk.search.search(1).front().log_likelihood;
  EXPECT_LT(with_way, without_way - 0.1);
  Walk other(tests::furnished_room());
  other.scan_from(T_map_robot);
  EXPECT_EQ(without_way, other.search.search(1).front().log_likelihood);
}

TEST(PlaceSearch, KnowsNothingWithoutAReading) {
  Walk walk(tests::furnished_room());
  EXPECT_TRUE(walk.search.search(1).empty());
  walk.search.add({});
  EXPECT_TRUE(walk.search.search(1).empty());
}

TEST(PlaceSearch, RefusesSettingsThatAreNotPositive) {
  const auto model = tests::sonar_model(tests::furnished_room());
  PlaceSearchParams params;
  params.lattice_m = 0.0;
  EXPECT_THROW(PlaceSearch(*model, params), std::invalid_argument);
  params = {};
  params.sectors = 0;
  EXPECT_THROW(PlaceSearch(*model, params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization

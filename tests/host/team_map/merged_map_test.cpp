// SPDX-License-Identifier: MIT
#include "host/team_map/merged_map.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_robot.hpp"

namespace echomap::team_map {
namespace {

using geometry::Pose2;
using mapping::CellState;

/// What a robot publishes, in the frame of the room.
MapShare share_of(const std::string& robot, const std::vector<Eigen::Vector2d>& places_m) {
  const RobotRecord record = tests::ideal_record(robot, tests::room_of_posts(), places_m, 0.0);
  std::vector<Pose2> T_room_submaps;
  for (const Eigen::Vector2d& place_m : places_m) {
    T_room_submaps.emplace_back(place_m.x(), place_m.y(), 0.0);
  }
  return {robot, record.body_radius_m, placed(record.submaps, T_room_submaps)};
}

TEST(MergedMap, IsMadeOfTheReadingsOfAll) {
  MergedMapper mapper{mapping::SonarMapperParams{}};
  const MergedMap merged =
      mapper.merge({share_of("a", tests::one_round_m()), share_of("b", tests::other_round_m())});
  EXPECT_EQ(merged.robots, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(merged.scans->size(), 16U);
  EXPECT_EQ(merged.grid->state(merged.grid->cell_at({0.2, 0.2})), CellState::kFree);
  bool has_wall = false;
  for (double x_m = 1.2; x_m < 1.45; x_m += 0.05) {
    has_wall =
        has_wall || merged.grid->state(merged.grid->cell_at({x_m, -0.3})) == CellState::kOccupied;
  }
  EXPECT_TRUE(has_wall);
}

/// A measures the right half from its middle, B the left one; both the middle.
TEST(MergedMap, KnowsWhoHasObservedACell) {
  mapping::CellBounds bounds{{0, 0}, {3, 3}};
  Provenance provenance(bounds, 0.05);
  provenance.add({1, 2}, 0);
  provenance.add({1, 2}, 5);
  provenance.add({9, 9}, 0);
  EXPECT_EQ(provenance.robots_at({1, 2}), 0b100001U);
  EXPECT_EQ(provenance.robots_at({2, 1}), 0U);
  EXPECT_EQ(provenance.robots_at({9, 9}), 0U);
  EXPECT_EQ(Provenance().robots_at({0, 0}), 0U);
}

TEST(MergedMap, SaysWhoHasSeenTheFloor) {
  MergedMapper mapper{mapping::SonarMapperParams{}};
  const MergedMap merged =
      mapper.merge({share_of("a", tests::one_round_m()), share_of("b", {{-0.8, -0.4}})});
  const auto robots_at = [&](double x_m, double y_m) {
    return merged.provenance.robots_at(merged.grid->cell_at({x_m, y_m}));
  };
  EXPECT_EQ(robots_at(-0.8, -0.2) & 0b10U, 0b10U);
  EXPECT_EQ(robots_at(0.9, 0.3) & 0b01U, 0b01U);
}

/// A robot that bumped into something that no sonar measures, where its bumper is.
TEST(MergedMap, HasWhatRobotsFeltOnTheirWays) {
  MergedMapper mapper{mapping::SonarMapperParams{}};
  MapShare share = share_of("a", {{0.0, 0.0}, {-0.4, -0.3}, {0.3, -0.4}});
  const auto evidence_at_bumper = [&] {
    const MergedMap merged = mapper.merge({share});
    return merged.grid->centilogits(merged.grid->cell_at({0.3, 0.3})).value_or(0);
  };
  const int before = evidence_at_bumper();
  share.placed.contacts.push_back({Pose2(0.3, 0.3 - share.body_radius_m, 1.5708), true, true});
  EXPECT_GT(evidence_at_bumper(), before);
}

/// Of the cells that one of two maps of the room knows.
double differing_share(const MergedMap& one, const MergedMap& other) {
  std::size_t differing = 0;
  std::size_t known = 0;
  for (int y = -20; y < 25; ++y) {
    for (int x = -25; x < 30; ++x) {
      differing += one.grid->state({x, y}) != other.grid->state({x, y}) ? 1 : 0;
      known += one.grid->state({x, y}) != CellState::kUnknown ? 1 : 0;
    }
  }
  return static_cast<double>(differing) / static_cast<double>(known);
}

TEST(MergedMap, IsTheSameWhenItIsMadeAtOnceAndStopByStop) {
  MergedMapper at_once{mapping::SonarMapperParams{}};
  MergedMapper by_stops{mapping::SonarMapperParams{}};
  const auto whole = share_of("a", tests::one_round_m());
  by_stops.merge({share_of("a", {{0.0, 0.0}, {0.4, 0.3}})});
  EXPECT_LT(differing_share(at_once.merge({whole}), by_stops.merge({whole})), 0.05);
}

/// More stops than a mapper matches anew with one that is new, those of the first robot before
/// those of the second.
TEST(MergedMap, IsTheSameWhenRobotsPublishTheirStopsInTurn) {
  std::vector<Eigen::Vector2d> places_m;
  for (int i = 0; i < 24; ++i) {
    places_m.emplace_back(-0.7 + 0.25 * (i % 6), -0.4 + 0.25 * (i / 6));
  }
  const auto first = [&](int stops) {
    return std::vector<Eigen::Vector2d>(places_m.begin(), places_m.begin() + stops);
  };
  MergedMapper in_turn{mapping::SonarMapperParams{}};
  MergedMap last;
  for (int stops = 4; stops <= 24; stops += 4) {
    last = in_turn.merge({share_of("a", first(stops)), share_of("b", first(stops))});
  }
  MergedMapper at_once{mapping::SonarMapperParams{}};
  const MergedMap whole = at_once.merge({share_of("a", places_m), share_of("b", places_m)});
  EXPECT_EQ(last.scans->size(), whole.scans->size());
  EXPECT_EQ(last.features->walls.size(), whole.features->walls.size());
  EXPECT_LT(differing_share(whole, last), 0.05);
}

}  // namespace
}  // namespace echomap::team_map

// SPDX-License-Identifier: MIT
#include "tests/benchmarks/covering_tour.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "host/strategies/stop_list_file.hpp"
#include "tests/support/offline_exploration.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::bench {
namespace {

class ToursOf : public testing::TestWithParam<const char*> {};

/// Along every leg, in steps of a centimetre.
TEST_P(ToursOf, KeepAwayFromWallsAndBeginAtTheStart) {
  const auto plan = tests::bundled_room(GetParam());
  const CoveringTourParams params;
  const CoveringTour tour = covering_tour(plan, params);
  const geometry::Pose2& T_world_map = plan.T_world_start();
  ASSERT_FALSE(tour.places.empty());
  EXPECT_LT(tour.places.front().position_m.norm(), 1e-9);
  for (std::size_t i = 1; i < tour.places.size(); ++i) {
    const Eigen::Vector2d from_m = T_world_map * tour.places[i - 1].position_m;
    const Eigen::Vector2d to_m = T_world_map * tour.places[i].position_m;
    for (double share = 0.0; share <= 1.0; share += 0.01 / (to_m - from_m).norm()) {
      const double off_m = plan.clearance_m(from_m + share * (to_m - from_m));
      ASSERT_GT(off_m, params.robot_radius_m + params.clearance_m - 2.0 * params.cell_m) << i;
    }
  }
}

TEST_P(ToursOf, SweepAtEachStopOnceAndAtNothingElse) {
  const auto plan = tests::bundled_room(GetParam());
  const CoveringTour tour = covering_tour(plan);
  const auto sweeps =
      std::count_if(tour.places.begin(), tour.places.end(), [](const auto& p) { return p.sweeps; });
  EXPECT_EQ(static_cast<std::size_t>(sweeps), tour.stops_m.size());
  EXPECT_LE(tour.stops_m.size(), StopChoiceParams{}.max_stops);
}

INSTANTIATE_TEST_SUITE_P(Rooms,
                         ToursOf,
                         testing::Values("living_room", "epuck_field", "attic", "corridor_t"));

TEST(CoveringTour, GivesARoomOf4By3MetresAboutTwentyStops) {
  const std::size_t stops = covering_tour(tests::bundled_room("living_room")).stops_m.size();
  EXPECT_GE(stops, 16U);
  EXPECT_LE(stops, 28U);
}

TEST(CoveringTour, IsReadBackFromItsFile) {
  const tests::ScratchFolder folder;
  const CoveringTour tour = covering_tour(tests::bundled_room("attic"));
  write_stop_list(folder / "stops.toml", tour.places);
  const auto places = strategies::load_stop_list(folder / "stops.toml");
  ASSERT_EQ(places.size(), tour.places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_LT((places[i].position_m - tour.places[i].position_m).norm(), 1e-3);
    EXPECT_EQ(places[i].sweeps, tour.places[i].sweeps);
  }
}

TEST(CoveringTour, RefusesARoomThatHasNoRoomForTheRobot) {
  CoveringTourParams params;
  params.robot_radius_m = 1.0;
  EXPECT_THROW(covering_tour(tests::bundled_room("epuck_field"), params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::bench

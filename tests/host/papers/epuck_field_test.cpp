// SPDX-License-Identifier: MIT
// The occupancy grid of Mahmood and Ridao 2017, section 4.1: an e-puck with eight infra-red sensors
// of 6 cm, a field of 0.8 x 0.6 m, cells of a millimetre.
#include "host/papers/epuck_field.hpp"

#include <filesystem>
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include "host/papers/epuck_grid_figures.hpp"
#include "host/papers/epuck_grid_picture.hpp"

namespace echomap::papers {
namespace {

const std::filesystem::path field_picture = ECHOMAP_BINARY_DIR "/papers/paper_002_grid.png";

constexpr std::uint32_t kFieldSeeds = 20;

void print(const std::string& what, const EpuckGridFigures& figures) {
  std::cout << what << ": walls found " << figures.walls_found << ", occupied within 5 mm "
            << figures.occupied_near << ", median " << 1000.0 * figures.occupied_median_m
            << " mm, floor found " << figures.free_found << ", free that is none "
            << figures.free_wrong << ", deepest " << 1000.0 * figures.deepest_m << " mm\n";
}

// Walls have gaps, as the paper's have: beams are narrow and a cell is a millimetre. Nothing is
// said of what no beam reaches, but a moat behind the walls is called free: oblique walls are
// silent.
TEST(Paper002Grid, HasItsWallsWhereTheyAreAndItsFloorFree) {
  for (std::uint32_t seed = 1; seed <= kFieldSeeds; ++seed) {
    const EpuckGridFigures figures = epuck_grid_figures(map_epuck_field(epuck_field(), {}, seed));
    print("seed " + std::to_string(seed), figures);
    EXPECT_GT(figures.walls_found, 0.85);
    EXPECT_LT(figures.walls_found, 0.95);
    EXPECT_GT(figures.occupied_near, 0.68);
    EXPECT_LT(figures.occupied_median_m, 0.003);
    EXPECT_GT(figures.free_found, 0.97);
    EXPECT_LT(figures.free_wrong, 0.15);
    EXPECT_LT(figures.deepest_m, 0.036);
  }
}

TEST(Paper002Grid, IsDrawn) {
  draw_under_walls(field_picture, map_epuck_field(epuck_field(), {}, 1));
  EXPECT_TRUE(std::filesystem::exists(field_picture));
}

TEST(Paper002Grid, ItsUnknownClotsOnTheFloorAreSmallerThanTheRobot) {
  const auto map = map_epuck_field(epuck_field(), {}, 1);
  const EpuckGridFigures before = epuck_grid_figures(map);
  const EpuckGridFigures after = epuck_grid_figures(without_small_clots(map));
  print("clots filled", after);
  EXPECT_GT(1.0 - before.free_found, 1.5 * (1.0 - after.free_found));
  EXPECT_GT(after.free_found, 0.99);
  EXPECT_LT(after.free_wrong - before.free_wrong, 0.002);
}

TEST(Paper002Grid, LosesItsWallsWhereSilenceWeighsAsMuchAsAnEcho) {
  EpuckGridParams params;
  params.occupied_log_odds = 0.85;
  params.free_log_odds = -0.85;
  const EpuckGridFigures figures = epuck_grid_figures(map_epuck_field(epuck_field(), params, 1));
  print("even odds", figures);
  EXPECT_LT(figures.walls_found, 0.2);
}

TEST(Paper002Grid, LosesItsFloorWhereSilenceSaysNothing) {
  EpuckGridParams params;
  params.silence_is_free = false;
  const EpuckGridFigures figures = epuck_grid_figures(map_epuck_field(epuck_field(), params, 1));
  print("silence left out", figures);
  EXPECT_LT(figures.free_found, 0.25);
  EXPECT_GT(figures.walls_found, 0.9);
}

// Ours believes no beam that a wall meets at a slant: no arcs stand behind the walls.
TEST(Paper002Grid, OursHasItsWallsWithinTenMillimetres) {
  for (std::uint32_t seed = 1; seed <= kFieldSeeds; ++seed) {
    const EpuckGridFigures figures = epuck_grid_figures(map_epuck_contacts(epuck_field(), seed));
    std::cout << "seed " << seed << ": RMS " << 1000.0 * figures.occupied_rms_m
              << " mm, floor found " << figures.free_found << ", free that is none "
              << figures.free_wrong << '\n';
    EXPECT_LT(figures.occupied_rms_m, 0.010);
    EXPECT_GT(figures.free_found, 0.95);
    EXPECT_LT(figures.free_wrong, 0.03);
  }
}

}  // namespace
}  // namespace echomap::papers

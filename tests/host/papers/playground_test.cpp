// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/papers/confidence_picture.hpp"
#include "host/papers/patch_figures.hpp"

// The grid of Hennessey et al., section II.B: patches and bump lines in 56 x 44 cells of 5 cm, over
// a playground of 2.07 x 1.75 m.
namespace echomap::papers {
namespace {

const std::filesystem::path playground_picture = ECHOMAP_BINARY_DIR "/papers/paper_003_grid.png";

constexpr std::uint32_t kPlaygroundSeeds = 20;

const Playground& playground() {
  static const Playground room = make_playground();
  return room;
}

void print(const std::string& what, const PatchFigures& figures) {
  std::cout << what << ": boxes found " << figures.boxes_found << ", walls found "
            << figures.walls_found << ", occupied rms " << figures.occupied_rms_m
            << " m, echoes rms " << figures.echo_rms_m << " m, open floor occupied "
            << figures.open_floor_wrong << ", low block " << figures.block << ", drift "
            << figures.final_error_m << " m\n";
}

TEST(PlaygroundGrid, HasTheRoomAndItsBoxes) {
  for (std::uint32_t seed = 1; seed <= kPlaygroundSeeds; ++seed) {
    const PatchDrive grid = map_playground(playground(), {}, seed);
    const PatchFigures figures = patch_figures(playground(), grid);
    print("seed " + std::to_string(seed), figures);
    EXPECT_GT(figures.boxes_found, 0.95);
    EXPECT_GT(figures.walls_found, 0.95);
    EXPECT_EQ(grid.bumps, 1);
  }
}

TEST(PlaygroundGrid, IsDrawn) {
  draw_confidence(
      playground_picture, map_playground(playground(), {}, 1).confidence, playground().for_bumper);
  EXPECT_TRUE(std::filesystem::exists(playground_picture));
}

// What drift moves off its cells, the known walls fill in again.
TEST(PlaygroundGrid, FindsMostOfTheWallsWhereTheyAreNotKnown) {
  int all_found = 0;
  for (std::uint32_t seed = 1; seed <= kPlaygroundSeeds; ++seed) {
    const PatchFigures figures =
        patch_figures(playground(), map_playground(playground(), {false, true, true}, seed));
    EXPECT_GT(figures.walls_found, 0.85);
    all_found += figures.walls_found > 0.98;
  }
  std::cout << "all walls found without knowing them: " << all_found << " of " << kPlaygroundSeeds
            << "\n";
  EXPECT_GE(all_found, 15);
}

// A patch lies on the beam's axis though its echo comes from anywhere in 32.8 degrees, and nothing
// is ever taken away: even without drift the walls grow wide.
TEST(PlaygroundGrid, SmearsWallsByItsCone) {
  const PatchFigures figures =
      patch_figures(playground(), map_playground(playground(), {false, true, false}, 1));
  print("without drift", figures);
  EXPECT_GT(figures.echo_rms_m, 0.05);
  EXPECT_GT(figures.occupied_rms_m, 0.1);
  EXPECT_GT(figures.open_floor_wrong, 0.05);
}

TEST(PlaygroundGrid, KnowsALowBlockByItsBump) {
  int only_by_bump = 0;
  for (std::uint32_t seed = 1; seed <= kPlaygroundSeeds; ++seed) {
    const double with =
        patch_figures(playground(), map_playground(playground(), {true, true, true}, seed)).block;
    const double without =
        patch_figures(playground(), map_playground(playground(), {true, false, true}, seed)).block;
    only_by_bump += with - without >= 0.5;
  }
  std::cout << "low block on its true cell: " << only_by_bump << " of " << kPlaygroundSeeds << "\n";
  EXPECT_GE(only_by_bump, 15);
  const PatchFigures still =
      patch_figures(playground(), map_playground(playground(), {true, true, false}, 1));
  EXPECT_GT(still.block, 1.5);
}

}  // namespace
}  // namespace echomap::papers

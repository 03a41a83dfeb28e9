// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/papers/confidence_picture.hpp"
#include "tests/papers/playground.hpp"

// The grid of Hennessey et al., section II.B: patches and bump lines in 56 x 44 cells of 5 cm, over
// a playground of 2.07 x 1.75 m.
namespace echomap::papers {
namespace {

const std::filesystem::path playground_picture = ECHOMAP_BINARY_DIR "/papers/paper_003_grid.png";

constexpr std::uint32_t kPlaygroundSeeds = 20;
/// One echo in the middle of a cell.
constexpr float kOccupied = 1.0F;
/// Open floor is farther than this from all that stands: patches of good echoes end before.
constexpr double kOpenFloorM = 0.2;
constexpr double kPlaygroundFoundM = 0.05;

const Playground& playground() {
  static const Playground room = make_playground();
  return room;
}

/// Shares, 0 .. 1, unless a unit says otherwise.
struct PatchFigures {
  double boxes_found = 0.0;       ///< Of their sides, an occupied cell within 5 cm.
  double walls_found = 0.0;       ///< The same of the room's.
  double occupied_rms_m = 0.0;    ///< Occupied cells' distances to the nearest side.
  double echo_rms_m = 0.0;        ///< The echoes', too.
  double open_floor_wrong = 0.0;  ///< Of the open floor, occupied.
  double block = 0.0;             ///< Confidence in the low block's face.
  double final_error_m = 0.0;
};

bool on_known_wall(const Eigen::Vector2d& point_m) {
  const auto& walls = playground().known_walls;
  return std::any_of(walls.begin(), walls.end(), [&](const geometry::Segment& wall) {
    return geometry::distance_m(wall, point_m) < 1e-6;
  });
}

/// The way to the door is neither.
bool on_box(const Eigen::Vector2d& point_m) { return !on_known_wall(point_m) && point_m.y() > 0.3; }

/// Points along the walls for which `chosen` holds, a centimetre apart.
template <typename Chooser>
std::vector<Eigen::Vector2d> wall_points_m(Chooser&& chosen) {
  std::vector<Eigen::Vector2d> points_m;
  for (const world::Wall& wall : playground().heard.walls()) {
    const Eigen::Vector2d offset_m = wall.segment.to_m - wall.segment.from_m;
    const int steps = static_cast<int>(std::lround(offset_m.norm() / 0.01));
    for (int i = 0; i < steps; ++i) {
      const Eigen::Vector2d point_m = wall.segment.from_m + (i + 0.5) / steps * offset_m;
      if (chosen(point_m)) {
        points_m.push_back(point_m);
      }
    }
  }
  return points_m;
}

double found_share(const std::vector<Eigen::Vector2d>& points_m,
                   const std::vector<Eigen::Vector2d>& occupied_m) {
  const auto found = std::count_if(points_m.begin(), points_m.end(), [&](const auto& point_m) {
    return std::any_of(occupied_m.begin(), occupied_m.end(), [&](const auto& center_m) {
      return (center_m - point_m).norm() <= kPlaygroundFoundM;
    });
  });
  return static_cast<double>(found) / static_cast<double>(points_m.size());
}

double distance_rms_m(const std::vector<Eigen::Vector2d>& points_m) {
  double squares = 0.0;
  for (const auto& point_m : points_m) {
    squares += std::pow(playground().met.clearance_m(point_m), 2);
  }
  return std::sqrt(squares / static_cast<double>(points_m.size()));
}

double open_floor_wrong(const mapping::CellField& field) {
  int open = 0;
  int wrong = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Eigen::Vector2d center_m = field.center_m(field.cell(i));
    if (playground().met.is_free(center_m) &&
        playground().met.clearance_m(center_m) > kOpenFloorM) {
      ++open;
      wrong += field[i] >= kOccupied;
    }
  }
  return static_cast<double>(wrong) / open;
}

PatchFigures figures_of(const PatchDrive& grid) {
  const mapping::CellField& field = grid.confidence;
  std::vector<Eigen::Vector2d> occupied_m;
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (field[i] >= kOccupied) {
      occupied_m.push_back(field.center_m(field.cell(i)));
    }
  }
  PatchFigures figures;
  figures.walls_found = found_share(wall_points_m(on_known_wall), occupied_m);
  figures.boxes_found = found_share(wall_points_m(on_box), occupied_m);
  figures.occupied_rms_m = distance_rms_m(occupied_m);
  figures.echo_rms_m = distance_rms_m(grid.echoes_m);
  figures.open_floor_wrong = open_floor_wrong(field);
  figures.block = field[field.index(field.cell_at({1.49, 1.84}))];
  figures.final_error_m = grid.final_error_m;
  return figures;
}

void print(const std::string& what, const PatchFigures& figures) {
  std::cout << what << ": boxes found " << figures.boxes_found << ", walls found "
            << figures.walls_found << ", occupied rms " << figures.occupied_rms_m
            << " m, echoes rms " << figures.echo_rms_m << " m, open floor occupied "
            << figures.open_floor_wrong << ", low block " << figures.block << ", drift "
            << figures.final_error_m << " m\n";
}

TEST(Paper003Grid, HasTheRoomAndItsBoxes) {
  for (std::uint32_t seed = 1; seed <= kPlaygroundSeeds; ++seed) {
    const PatchDrive grid = map_playground(playground(), {}, seed);
    const PatchFigures figures = figures_of(grid);
    print("seed " + std::to_string(seed), figures);
    EXPECT_GT(figures.boxes_found, 0.95);
    EXPECT_GT(figures.walls_found, 0.95);
    EXPECT_EQ(grid.bumps, 1);
  }
}

TEST(Paper003Grid, IsDrawn) {
  draw_confidence(
      playground_picture, map_playground(playground(), {}, 1).confidence, playground().met);
  EXPECT_TRUE(std::filesystem::exists(playground_picture));
}

// What drift moves off its cells, the known walls fill in again.
TEST(Paper003Grid, FindsMostOfTheWallsWhereTheyAreNotKnown) {
  int all_found = 0;
  for (std::uint32_t seed = 1; seed <= kPlaygroundSeeds; ++seed) {
    const PatchFigures figures =
        figures_of(map_playground(playground(), {false, true, true}, seed));
    EXPECT_GT(figures.walls_found, 0.85);
    all_found += figures.walls_found > 0.98;
  }
  std::cout << "all walls found without knowing them: " << all_found << " of " << kPlaygroundSeeds
            << "\n";
  EXPECT_GE(all_found, 15);
}

// A patch lies on the beam's axis though its echo comes from anywhere in 32.8 degrees, and nothing
// is ever taken away: even without drift the walls grow wide.
TEST(Paper003Grid, SmearsWallsByItsCone) {
  const PatchFigures figures = figures_of(map_playground(playground(), {false, true, false}, 1));
  print("without drift", figures);
  EXPECT_GT(figures.echo_rms_m, 0.05);
  EXPECT_GT(figures.occupied_rms_m, 0.1);
  EXPECT_GT(figures.open_floor_wrong, 0.05);
}

TEST(Paper003Grid, KnowsALowBlockByItsBump) {
  int only_by_bump = 0;
  for (std::uint32_t seed = 1; seed <= kPlaygroundSeeds; ++seed) {
    const double with = figures_of(map_playground(playground(), {true, true, true}, seed)).block;
    const double without =
        figures_of(map_playground(playground(), {true, false, true}, seed)).block;
    only_by_bump += with - without >= 0.5;
  }
  std::cout << "low block on its true cell: " << only_by_bump << " of " << kPlaygroundSeeds << "\n";
  EXPECT_GE(only_by_bump, 15);
  const PatchFigures still = figures_of(map_playground(playground(), {true, true, false}, 1));
  EXPECT_GT(still.block, 1.5);
}

}  // namespace
}  // namespace echomap::papers

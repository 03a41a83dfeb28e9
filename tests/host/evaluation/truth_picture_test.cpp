// SPDX-License-Identifier: MIT
#include "host/evaluation/truth_picture.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"
#include "tests/support/png_picture.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::evaluation {
namespace {

/// A room of 1 x 0.6 m with its lower left corner at (0, 0), in cells of 10 cm.
MapTruth plain_room() {
  const tests::DrawnMap floor(6, std::string(10, '.'));
  return {tests::map_from(floor, 0.1),
          {{{0, 0}, {1, 0}}, {{1, 0}, {1, 0.6}}, {{1, 0.6}, {0, 0.6}}, {{0, 0.6}, {0, 0}}}};
}

/// The verdicts on a map in the world frame, drawn like the map.
tests::DrawnMap verdicts_on(const mapping::RasterMap& map) {
  constexpr char kMarks[] = {' ', '.', '#', 'm', 'F', 'W'};
  tests::DrawnMap drawing;
  for (int row = map.rows() - 1; row >= 0; --row) {
    std::string line;
    for (int column = 0; column < map.columns(); ++column) {
      const auto verdict = verdict_on({column, row}, map, {}, plain_room(), {});
      line.push_back(kMarks[static_cast<int>(verdict)]);
    }
    drawing.push_back(line);
  }
  return drawing;
}

TEST(TruthPicture, JudgesEveryCell) {
  // The map has a cell of margin around the room: its left part is missed, a wall stands in the
  // middle, and floor and wall reach beyond the right wall.
  const auto map = tests::map_from({"  ##########",
                                    "  .........#",
                                    "  .........#",
                                    "  ...##.....",
                                    "  ...##.....",
                                    "  .........#",
                                    "  .........#",
                                    "  ##########"},
                                   0.1,
                                   {-0.1, -0.1});
  EXPECT_EQ(verdicts_on(map),
            (tests::DrawnMap{"  ##########",
                             " m.........#",
                             " m.........#",
                             " m...WW....F",
                             " m...WW....F",
                             " m.........#",
                             " m.........#",
                             "  ##########"}));
}

TEST(TruthPicture, PlacesTheMapByItsPose) {
  const auto map = tests::map_from({"."}, 0.1);
  EXPECT_EQ(verdict_on({0, 0}, map, {0.5, 0.3, 1.0}, plain_room(), {}), CellVerdict::kFloorFound);
  EXPECT_EQ(verdict_on({0, 0}, map, {5.5, 0.3, 1.0}, plain_room(), {}),
            CellVerdict::kFloorInvented);
}

TEST(TruthPicture, TellsFloorInAnObstacleFromOtherInventedFloor) {
  const auto map = tests::map_from({"..#"}, 0.1);
  const std::vector<geometry::Polygon> box{{{0.0, 0.0}, {0.0, 0.1}, {0.1, 0.1}, {0.1, 0.0}}};
  EXPECT_EQ(verdict_on({0, 0}, map, {}, plain_room(), box), CellVerdict::kSolidCalledFree);
  EXPECT_EQ(verdict_on({1, 0}, map, {}, plain_room(), box), CellVerdict::kFloorFound);
  EXPECT_EQ(verdict_on({2, 0}, map, {-0.2, 0.0, 0.0}, plain_room(), box), CellVerdict::kWallFound);
}

TEST(TruthPicture, PaintsFloorInAnObstacle) {
  const tests::ScratchFolder folder;
  MapTruth truth = plain_room();
  const auto pixels_of = [&](const char* name) {
    write_truth_picture(folder / name, tests::map_from({"..", ".."}, 0.1, {0.3, 0.2}), {}, truth);
    const tests::PngPicture picture(folder / name);
    return std::count(picture.pixels.begin(), picture.pixels.end(), 0xCC79A7);
  };
  const auto legend_alone = pixels_of("a.png");
  const geometry::Polygon box{{0.3, 0.2}, {0.3, 0.4}, {0.5, 0.4}, {0.5, 0.2}};
  for (std::size_t i = 0; i < box.size(); ++i) {
    truth.walls.push_back(geometry::side(box, i));
  }
  EXPECT_GT(legend_alone, 0);
  EXPECT_GE(pixels_of("b.png"), legend_alone + 3 * 8 * 8) << "four cells less their outline";
}

TEST(TruthPicture, HasTheColoursOfTheErrorsAndALegend) {
  const tests::ScratchFolder folder;
  const auto map = tests::map_from({"...", ".#.", "..."}, 0.1, {0.3, 0.2});
  write_truth_picture(folder / "a.png", map, {}, plain_room());
  const tests::PngPicture picture(folder / "a.png");
  const std::set<int> colours(picture.pixels.begin(), picture.pixels.end());
  for (const int colour : {0xE69F00, 0x56B4E9, 0x009E73, 0xEBF0EB}) {
    EXPECT_EQ(colours.count(colour), 1U) << std::hex << colour;
  }
  EXPECT_GE(picture.height, 6 * 8 + 44 + 7 * 24) << "seven lines of legend";
}

TEST(TruthPicture, RefusesAMapThatLiesElsewhere) {
  const tests::ScratchFolder folder;
  EXPECT_THROW(
      write_truth_picture(folder / "a.png", tests::map_from({"."}, 0.1), {1e9, 0, 0}, plain_room()),
      std::invalid_argument);
}

}  // namespace
}  // namespace echomap::evaluation

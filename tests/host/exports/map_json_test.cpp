// SPDX-License-Identifier: MIT
#include "host/exports/map_json.hpp"

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/exports/grid_csv.hpp"
#include "host/files/atomic_file.hpp"
#include "host/mapping/raster_map.hpp"
#include "tests/support/panned_stops.hpp"
#include "tests/support/run_tables.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

using nlohmann::json;

class MapJsonTest : public ::testing::Test {
 protected:
  json written(const pipeline::Snapshot& snapshot,
               const std::optional<mapping::PolygonMap>& outline = std::nullopt) {
    write_map_json(folder / "map.json", snapshot, outline);
    return json::parse(files::read_text_file(folder / "map.json"));
  }

  tests::ScratchFolder folder;
};

TEST_F(MapJsonTest, SaysHowToReadIt) {
  const json map = written(tests::run_of_two_stops());
  EXPECT_EQ(map.at("format"), "echomap-map");
  EXPECT_EQ(map.at("version"), kMapJsonVersion);
  EXPECT_EQ(map.at("units").at("length"), "m");
  EXPECT_EQ(map.at("frame").get<std::string>().substr(0, 4), "map:");
}

TEST_F(MapJsonTest, HasEveryCellOfTheGridTheTopRowFirst) {
  mapping::OccupancyGrid grid;
  grid.add({-3, 1}, -300);
  grid.add({-2, 2}, 300);
  const json map = written(tests::snapshot_of(grid));
  EXPECT_EQ(map.at("rows"), 2);
  EXPECT_EQ(map.at("columns"), 2);
  EXPECT_EQ(map.at("resolution_m"), 0.05);
  EXPECT_EQ(map.at("origin_m"), json::parse("[-0.15, 0.05]"));
  EXPECT_EQ(map.at("cells"), json::parse("[[null, 0.953], [0.047, null]]"));
}

TEST_F(MapJsonTest, AgreesWithTheTableOfTheGrid) {
  const pipeline::Snapshot snapshot = tests::run_of_two_stops();
  const json cells = written(snapshot).at("cells");
  write_occupancy_grid_csv(folder / "grid.csv", *snapshot.grid);
  const auto grid = tests::read_occupancy_grid_csv(folder / "grid.csv");
  const auto rows = static_cast<int>(cells.size());
  ASSERT_EQ(rows, 21);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < 50; ++column) {
      const json& cell =
          cells.at(static_cast<std::size_t>(row)).at(static_cast<std::size_t>(column));
      const auto expected = grid.at(column, rows - 1 - row);
      ASSERT_EQ(cell.is_null(), !expected.has_value());
      EXPECT_NEAR(cell.get<double>(), expected.value_or(0.0), 6e-4);
    }
  }
}

TEST_F(MapJsonTest, HasTheOutlineWithItsHoles) {
  const mapping::PolygonMap outline({{0, 0}, {2, 0}, {2, 1}, {0, 1}},
                                    {{{0.5, 0.5}, {0.5, 0.7}, {0.7, 0.7}, {0.7, 0.5}}});
  const json read = written(tests::run_of_two_stops(), outline).at("outline");
  EXPECT_EQ(read.at("corners_m").size(), 4U);
  ASSERT_EQ(read.at("holes_m").size(), 1U);
  EXPECT_EQ(read.at("holes_m").at(0).size(), 4U);
  EXPECT_EQ(read.at("area_m2"), 1.96);
  EXPECT_TRUE(written(tests::run_of_two_stops()).at("outline").is_null());
}

TEST_F(MapJsonTest, HasFittedWallsAndObstacles) {
  pipeline::Snapshot snapshot = tests::run_of_two_stops();
  mapping::SonarFeatures features;
  features.walls = {{{0.0, 1.0}, {2.0, 1.25}}};
  features.circles = {{{0.5, -0.25}, 0.125, {}}};
  snapshot.features = std::make_shared<const mapping::SonarFeatures>(features);
  const json map = written(snapshot);
  EXPECT_EQ(map.at("walls"), json::parse(R"([{"from_m": [0.0, 1.0], "to_m": [2.0, 1.25]}])"));
  EXPECT_EQ(map.at("obstacles"), json::parse(R"([{"center_m": [0.5, -0.25], "radius_m": 0.125}])"));
}

TEST_F(MapJsonTest, HasTheTrajectoryItsStartAndItsStops) {
  const json map = written(tests::run_of_two_stops());
  ASSERT_EQ(map.at("trajectory").size(), 301U);
  EXPECT_EQ(map.at("trajectory_columns").size(), 4U);
  EXPECT_EQ(map.at("trajectory").at(150), json::parse("[15.0, 0.5, 0.0, 0.0]"));
  EXPECT_EQ(map.at("start").at("x_m"), 0.0);
  EXPECT_EQ(map.at("robot").at("x_m"), 1.0);
  ASSERT_EQ(map.at("stops").size(), 2U);
  EXPECT_EQ(map.at("stops").at(1).at("x_m"), 1.0);
  EXPECT_EQ(map.at("stops").at(1).at("readings"), 19);
  EXPECT_EQ(map.at("free_area_m2"), 49 * 20 * 0.0025);
}

TEST_F(MapJsonTest, HasARowOfCellsALine) {
  written(tests::run_of_two_stops());
  const std::string text = files::read_text_file(folder / "map.json");
  // Braces, keys, and for either list its rows and its closing bracket.
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2 + 18 + 21 + 1 + 301 + 1);
}

TEST_F(MapJsonTest, OfNothingIsADocument) {
  const json map = written(tests::snapshot_of(mapping::OccupancyGrid()));
  EXPECT_TRUE(map.at("start").is_null());
  EXPECT_TRUE(map.at("trajectory").empty());
  EXPECT_EQ(map.at("cells"), json::parse("[[null]]"));
}

}  // namespace
}  // namespace echomap::exports

// SPDX-License-Identifier: MIT
#include "host/exports/map_svg.hpp"

#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/mapping/raster_map.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exports {
namespace {

using ::testing::HasSubstr;

/// Floor of 2 x 1 m with its lower left corner at (-1, 0.5), a wall above.
mapping::OccupancyGrid hall_ahead() {
  mapping::OccupancyGrid grid;
  for (int y = 10; y < 31; ++y) {
    for (int x = -20; x < 20; ++x) {
      grid.add({x, y}, y == 30 ? 300 : -300);
    }
  }
  return grid;
}

class MapSvgTest : public ::testing::Test {
 protected:
  std::string written(const pipeline::Snapshot& snapshot) {
    write_map_svg(folder / "map.svg",
                  snapshot,
                  mapping::polygon_from_raster(mapping::rasterize(*snapshot.grid)));
    return files::read_text_file(folder / "map.svg");
  }
  static std::string path_of(const std::string& svg, const std::string& id) {
    const std::regex pattern("<path id=\"" + id + "\"[^>]* d=\"([^\"]*)\"");
    std::smatch match;
    return std::regex_search(svg, match, pattern) ? match[1].str() : "none";
  }
  /// Of the rectangles of a group.
  static double area_m2(const std::string& path) {
    static const std::regex rectangle("M\\S+ \\S+?h([0-9.]+)v([0-9.]+)h-[0-9.]+z");
    double area_m2 = 0.0;
    for (std::sregex_iterator at(path.begin(), path.end(), rectangle), end; at != end; ++at) {
      area_m2 += std::stod((*at)[1]) * std::stod((*at)[2]);
    }
    return area_m2;
  }

  tests::ScratchFolder folder;
};

TEST_F(MapSvgTest, HoldsLandmarksIfThereAreAny) {
  const auto snapshot = tests::snapshot_of(hall_ahead());
  EXPECT_EQ(path_of(written(snapshot), "landmarks"), "none");
  MapStyle style;
  style.landmarks.walls = {{{0.0, 1.5}, {0.5, 1.5}}};
  write_map_svg(folder / "map.svg", snapshot, std::nullopt, style);
  EXPECT_EQ(path_of(files::read_text_file(folder / "map.svg"), "landmarks"), "M0 1.5L0.5 1.5");
}

TEST_F(MapSvgTest, HoldsEveryCellInMetres) {
  const std::string svg = written(tests::snapshot_of(hall_ahead()));
  EXPECT_NEAR(area_m2(path_of(svg, "floor")), 2.0, 1e-9);
  EXPECT_NEAR(area_m2(path_of(svg, "walls")), 0.1, 1e-9);
  EXPECT_THAT(path_of(svg, "floor"), HasSubstr("M-1 0.5h2v0.05h-2z"));
  EXPECT_EQ(path_of(svg, "outline"), "M-1 1.5L-1 0.5L1 0.5L1 1.5z");
}

TEST_F(MapSvgTest, ShowsTrailAndEchoes) {
  mapping::PointCloudMap points;
  points.add({geometry::Pose2(), geometry::Pose2(), 0.75});
  const std::string svg = written(tests::snapshot_of(
      hall_ahead(), {tests::pose_at(0, {}), tests::pose_at(1, {0.5, 0.25, 0})}, points));
  EXPECT_EQ(path_of(svg, "trail"), "M0 0L0.5 0.25");
  EXPECT_EQ(path_of(svg, "echoes"), "M0.75 0h0");
  EXPECT_THAT(path_of(svg, "start"), HasSubstr("a"));
  EXPECT_THAT(svg, HasSubstr(">start</text>"));
}

TEST_F(MapSvgTest, HasItsGridOnTheFloorAndBelowTheWalls) {
  const std::string svg = written(tests::snapshot_of(hall_ahead()));
  EXPECT_LT(svg.find("id=\"floor\""), svg.find("id=\"grid\""));
  EXPECT_LT(svg.find("id=\"grid\""), svg.find("id=\"walls\""));
  EXPECT_THAT(path_of(svg, "grid"), HasSubstr("M-0.5 -0.15L-0.5 1.6M0 -0.15L0 1.6"));
}

TEST_F(MapSvgTest, OfNothingIsStillAPicture) {
  const std::string svg = written(tests::snapshot_of(mapping::OccupancyGrid()));
  EXPECT_THAT(svg, HasSubstr("</svg>"));
  EXPECT_EQ(path_of(svg, "floor"), "");
  EXPECT_EQ(path_of(svg, "outline"), "none");
}

}  // namespace
}  // namespace echomap::exports

// SPDX-License-Identifier: MIT
#include "host/exports/pgm_yaml.hpp"

#include <cstdlib>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/exports/pgm_image.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

using mapping::CellState;
using tests::DrawnMap;

const DrawnMap kRoom{"#### ", "#..# ", "#... ", "#####"};

TEST(PgmYaml, ReadsBackTheSameMap) {
  const tests::ScratchFolder folder;
  write_pgm_yaml(folder / "map.yaml", tests::map_from(kRoom, 0.05, {-1.55, 0.3}));
  const auto read = read_pgm_yaml(folder / "map.yaml");
  EXPECT_EQ(tests::drawing_of(read), kRoom);
  EXPECT_EQ(read.resolution_m(), 0.05);
  EXPECT_EQ(read.origin_m(), Eigen::Vector2d(-1.55, 0.3));
}

TEST(PgmYaml, HasThePixelsOfMapSaverWithTheTopRowFirst) {
  const tests::ScratchFolder folder;
  write_pgm_yaml(folder / "map.yaml", tests::map_from({"# ", ".."}));
  EXPECT_EQ(read_pgm(folder / "map.pgm").pixels, (std::vector<std::uint8_t>{0, 205, 254, 254}));
}

TEST(PgmYaml, NeverReadsUnknownAsFree) {
  const tests::ScratchFolder folder;
  write_pgm_yaml(folder / "map.yaml", tests::map_from({"   ", "   "}));
  EXPECT_EQ(tests::drawing_of(read_pgm_yaml(folder / "map.yaml")), (DrawnMap{"   ", "   "}));
}

TEST(PgmYaml, CallsAPixelAtTheThresholdFreeAsNav2Does) {
  const tests::ScratchFolder folder;
  write_pgm(folder / "a.pgm", {3, 1, {203, 204, 205}});
  files::write_text_file(folder / "a.yaml",
                         "image: a.pgm\nresolution: 1\norigin: [0, 0, 0]\nfree_thresh: 0.2\n");
  EXPECT_EQ(tests::drawing_of(read_pgm_yaml(folder / "a.yaml")), DrawnMap{" .."});
}

TEST(PgmYaml, GoesByThresholdsAndNegateOfTheFile) {
  const tests::ScratchFolder folder;
  write_pgm(folder / "a.pgm", {4, 1, {10, 60, 200, 250}});
  const auto read_with = [&](const std::string& rules) {
    files::write_text_file(folder / "a.yaml",
                           "image: a.pgm\nresolution: 1\norigin: [0, 0, 0]\n" + rules);
    return tests::drawing_of(read_pgm_yaml(folder / "a.yaml"));
  };
  EXPECT_EQ(read_with("negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"), DrawnMap{"## ."});
  EXPECT_EQ(read_with("mode: scale\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"),
            DrawnMap{"## ."});
  EXPECT_EQ(read_with("negate: 1\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"), DrawnMap{". ##"});
  EXPECT_EQ(read_with("negate: 0\noccupied_thresh: 0.9\nfree_thresh: 0.25\n"), DrawnMap{"# .."});
}

/// What a map server makes of a cell: ROS 1's and Nav2's numbers of an OccupancyGrid message.
enum Served : int { kServedUnknown = -1, kServedFree = 0, kServedOccupied = 100 };

/// The rule of ROS 1's map_server (wiki.ros.org/map_server, "Value Interpretation"): with
/// p = (255 - x) / 255 a pixel x is occupied above occupied_thresh, free below free_thresh, else
/// unknown.
Served served_by_ros1(int pixel, double occupied_thresh, double free_thresh) {
  const double p = (255 - pixel) / 255.0;
  return p > occupied_thresh ? kServedOccupied : p < free_thresh ? kServedFree : kServedUnknown;
}

/// The rule of Nav2's map_server in mode trinary (docs.nav2.org, "Map Server / Saver"): the same
/// with both thresholds included.
Served served_by_nav2(int pixel, double occupied_thresh, double free_thresh) {
  const double p = (255 - pixel) / 255.0;
  return p >= occupied_thresh ? kServedOccupied : p <= free_thresh ? kServedFree : kServedUnknown;
}

double yaml_number(const std::string& yaml, const std::string& key) {
  std::smatch match;
  EXPECT_TRUE(std::regex_search(yaml, match, std::regex("\\n" + key + ": ([0-9.]+)\\n"))) << key;
  return std::stod(match[1]);
}

TEST(PgmYaml, IsReadAlikeByTheRulesOfRos1AndNav2) {
  const tests::ScratchFolder folder;
  const auto map = tests::map_from(kRoom);
  write_pgm_yaml(folder / "map.yaml", map);
  const std::string yaml = files::read_text_file(folder / "map.yaml");
  EXPECT_THAT(yaml, ::testing::HasSubstr("\nmode: trinary\n"));
  EXPECT_THAT(yaml, ::testing::HasSubstr("\nnegate: 0\n"));
  const double occupied = yaml_number(yaml, "occupied_thresh");
  const double free = yaml_number(yaml, "free_thresh");
  const auto image = read_pgm(folder / "map.pgm");
  int unseen = 0;
  for (int row = 0; row < map.rows(); ++row) {
    for (int column = 0; column < map.columns(); ++column) {
      const auto index = static_cast<std::size_t>((map.rows() - 1 - row) * map.columns() + column);
      const CellState state = map.state({column, row});
      const Served expected = state == CellState::kFree       ? kServedFree
                              : state == CellState::kOccupied ? kServedOccupied
                                                              : kServedUnknown;
      EXPECT_EQ(served_by_ros1(image.pixels[index], occupied, free), expected);
      EXPECT_EQ(served_by_nav2(image.pixels[index], occupied, free), expected);
      unseen += state == CellState::kUnknown ? 1 : 0;
    }
  }
  EXPECT_EQ(unseen, 3);
}

TEST(PgmYaml, IsReadByMrptWhereThatIsInstalled) {
  const std::string reader = ECHOMAP_ROS_MAP_YAML_TO_MRPT;
  if (reader.empty() || reader.ends_with("NOTFOUND")) {
    GTEST_SKIP() << "ros-map-yaml2mrpt of Debian's mrpt-apps is not installed";
  }
  const tests::ScratchFolder folder;
  write_pgm_yaml(folder / "map.yaml", tests::map_from(kRoom, 0.05, {-1.55, 0.3}));
  const std::string command = reader + " -w -i " + (folder / "map.yaml").string() + " -d " +
                              folder.path().string() + " > " + (folder / "said").string() + " 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << files::read_text_file(folder / "said");
  EXPECT_TRUE(std::filesystem::exists(folder / "map.gridmap.gz"))
      << files::read_text_file(folder / "said");
}

}  // namespace
}  // namespace echomap::exports

// SPDX-License-Identifier: MIT
#include "tests/support/wean_map.hpp"

#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/datasets/wean_log.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/real_data.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::tests {
namespace {

using ::testing::HasSubstr;

std::string head(int columns, int rows) {
  return "robot_specifications->global_mapsize_x  " + std::to_string(10 * columns) +
         "\nrobot_specifications->global_mapsize_y  " + std::to_string(10 * rows) +
         "\nrobot_specifications->resolution  10\nrobot_specifications->autoshifted_x  0\n"
         "robot_specifications->autoshifted_y  0\n\nglobal_map[0]: " +
         std::to_string(columns) + " " + std::to_string(rows) + "\n";
}

class WeanMapTest : public ::testing::Test {
 protected:
  mapping::RasterMap read(const std::string& text) {
    files::write_text_file(folder / "wean.dat", text);
    return read_wean_map(folder / "wean.dat");
  }
  std::string complaint(const std::string& text) {
    return thrown_text<files::FileError>([&] { read(text); });
  }

  ScratchFolder folder;
};

TEST_F(WeanMapTest, ALineIsAColumnFromBelow) {
  const auto map = read(head(2, 3) + "1 1 0\n1 -1 -1\n");
  EXPECT_EQ(drawing_of(map), (DrawnMap{"# ", ". ", ".."}));
  EXPECT_EQ(map.resolution_m(), 0.1);
  EXPECT_EQ(map.origin_m(), Eigen::Vector2d(0.0, 0.0));
}

TEST_F(WeanMapTest, ANumberIsTheProbabilityOfFreeFloor) {
  EXPECT_EQ(drawing_of(read(head(5, 1) + "0.000\n0.300\n0.500\n0.900\n-1.000\n")),
            DrawnMap{"## . "});
}

TEST_F(WeanMapTest, NamesTheLineThatIsWrong) {
  const std::string cell = head(1, 1);
  EXPECT_THAT(complaint(cell + "1.5\n"), HasSubstr("wean.dat:8: "));
  EXPECT_THAT(complaint(cell + "-0.5\n"), HasSubstr("neither -1 nor from 0 to 1"));
  EXPECT_THAT(complaint(cell + "1 1\n"), HasSubstr("wean.dat:8: "));
  EXPECT_THAT(complaint(head(1, 2) + "1\n"), HasSubstr("wean.dat:8: "));
  EXPECT_THAT(complaint(cell + "1\n1\n"), HasSubstr("wean.dat:9: "));
  EXPECT_THAT(complaint(cell), HasSubstr("the file ends before the last column"));
  EXPECT_THAT(complaint("nonsense 3\n"), HasSubstr("wean.dat:1: "));
}

TEST_F(WeanMapTest, TheHeadHasToAgreeWithItself) {
  const auto with = [](const std::string& wrong, const std::string& right) {
    std::string text = head(1, 1);
    return text.replace(text.find(right), right.size(), wrong) + "1\n";
  };
  EXPECT_THAT(complaint(with("[0]: 2 1", "[0]: 1 1")), HasSubstr("wean.dat:7: "));
  EXPECT_THAT(complaint(with("[0]: 1 0", "[0]: 1 1")), HasSubstr("wean.dat:7: "));
  EXPECT_THAT(complaint(with("resolution  0", "resolution  10")), HasSubstr("wean.dat:3: "));
  EXPECT_THAT(complaint(with("autoshifted_y  5", "autoshifted_y  0")),
              HasSubstr("wean.dat:5: a shifted map"));
}

/// The share of the beams of a log's last scan that end within 20 cm of a wall.
double share_at_walls(const mapping::RasterMap& map,
                      const std::filesystem::path& log,
                      const geometry::Pose2& T_map_robot) {
  std::optional<sensors::RangeScan> last;
  const auto reader = datasets::open_wean_log(log);
  while (const auto record = reader->next()) {
    if (const auto* scan = std::get_if<sensors::RangeScan>(&*record)) {
      last = *scan;
    }
  }
  const auto is_wall_near = [&](const Eigen::Vector2d& place_m) {
    const auto cell = map.cell_at(place_m);
    for (int y = cell.y - 2; y <= cell.y + 2; ++y) {
      for (int x = cell.x - 2; x <= cell.x + 2; ++x) {
        if (map.state({x, y}) == mapping::CellState::kOccupied) {
          return true;
        }
      }
    }
    return false;
  };
  double beams = 0.0;
  double at_walls = 0.0;
  for (const auto& beam : last->beams) {
    if (beam.range_m) {
      const Eigen::Vector2d seen_m = *beam.range_m * geometry::unit_vector(beam.bearing_rad);
      ++beams;
      at_walls += is_wall_near(T_map_robot * last->T_robot_sensor * seen_m) ? 1.0 : 0.0;
    }
  }
  return at_walls / beams;
}

TEST(RealWeanMap, FitsTheLastScanOfItsLogWhereALocalizerHasFoundIt) {
  const auto map_file = real_data("wean_mcl/wean.dat.gz");
  const auto log = real_data("wean_mcl/robotdata1.log.gz");
  ECHOMAP_SKIP_WITHOUT(map_file);
  const auto map = read_wean_map(map_file);
  EXPECT_EQ(map.columns(), 800);
  EXPECT_EQ(map.rows(), 800);
  mapping::RasterMap transposed(800, 800, map.resolution_m(), map.origin_m());
  for (int y = 0; y < 800; ++y) {
    for (int x = 0; x < 800; ++x) {
      transposed.set({x, y}, map.state({y, x}));
    }
  }
  const geometry::Pose2 T_map_robot(40.00, 41.51, 1.32);
  EXPECT_GT(share_at_walls(map, log, T_map_robot), 0.85);
  EXPECT_LT(share_at_walls(transposed, log, T_map_robot), 0.6);
}

}  // namespace
}  // namespace echomap::tests

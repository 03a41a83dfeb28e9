// SPDX-License-Identifier: MIT
#include "host/evaluation/truth_directory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"
#include "tests/support/truth_files.hpp"

namespace echomap::evaluation {
namespace {

using ::testing::HasSubstr;

class TruthDirectoryTest : public ::testing::Test {
 protected:
  TruthDirectoryTest() { tests::write_truth_files(folder.path()); }
  std::string complaint() {
    return tests::thrown_text<files::FileError>([&] { read_truth(folder.path()); });
  }

  tests::ScratchFolder folder;
};

TEST_F(TruthDirectoryTest, ReadsRoomWallsAndWay) {
  const Truth truth = read_truth(folder.path());
  EXPECT_EQ(truth.map.cells.columns(), 20);
  ASSERT_EQ(truth.map.walls.size(), 4U);
  EXPECT_EQ(truth.map.walls[1].from_m, Eigen::Vector2d(2.0, 0.0));
  EXPECT_EQ(truth.map.walls[1].to_m, Eigen::Vector2d(2.0, 1.1));
  EXPECT_EQ(truth.trajectory.size(), 2U);
}

TEST_F(TruthDirectoryTest, NamesTheFileThatIsBroken) {
  files::write_text_file(folder / "truth_walls.geojson", "{\"features\": [");
  EXPECT_THAT(complaint(), HasSubstr("truth_walls.geojson"));
  files::write_text_file(folder / "truth_walls.geojson", "{\"walls\": 3}");
  EXPECT_THAT(complaint(), HasSubstr("truth_walls.geojson"));
  std::filesystem::remove(folder / "truth_map.pgm");
  EXPECT_THAT(complaint(), HasSubstr("truth_map.pgm"));
}

}  // namespace
}  // namespace echomap::evaluation

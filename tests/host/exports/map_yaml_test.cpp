// SPDX-License-Identifier: MIT
#include "host/exports/map_yaml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::exports {
namespace {

using ::testing::HasSubstr;

class MapYamlTest : public ::testing::Test {
 protected:
  MapYaml read(const std::string& text) {
    files::write_text_file(folder / "map.yaml", text);
    return read_map_yaml(folder / "map.yaml");
  }
  std::string complaint(const std::string& text) {
    return tests::thrown_text<files::FileError>([&] { read(text); });
  }

  tests::ScratchFolder folder;
};

TEST_F(MapYamlTest, WritesTheKeysOfMapServer) {
  MapYaml yaml;
  yaml.image = "map.pgm";
  yaml.resolution_m = 0.05;
  yaml.origin_m = {-31 * 0.05, 0.3};
  write_map_yaml(folder / "map.yaml", yaml);
  EXPECT_EQ(files::read_text_file(folder / "map.yaml"),
            "image: map.pgm\nmode: trinary\nresolution: 0.05\norigin: [-1.55, 0.3, 0]\n"
            "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST_F(MapYamlTest, ReadsWhatMapSaverWrites) {
  const MapYaml yaml = read(
      "image: testmap.pgm\nresolution: 0.1\norigin: [2.0, 3.0, 0.000000]\n"
      "negate: 1\noccupied_thresh: 0.7\nfree_thresh: 0.2  # of the paper\n\n");
  EXPECT_EQ(yaml.image, "testmap.pgm");
  EXPECT_EQ(yaml.resolution_m, 0.1);
  EXPECT_EQ(yaml.origin_m, Eigen::Vector2d(2.0, 3.0));
  EXPECT_TRUE(yaml.negate);
  EXPECT_EQ(yaml.occupied_threshold, 0.7);
  EXPECT_EQ(yaml.free_threshold, 0.2);
}

TEST_F(MapYamlTest, NamesTheLineThatIsWrong) {
  EXPECT_THAT(complaint("image: a.pgm\nresolution: fine\n"),
              HasSubstr("map.yaml:2: 'fine' is not a finite number"));
  EXPECT_THAT(complaint("image: a.pgm\nnonsense\n"),
              HasSubstr("map.yaml:2: expected `key: value`"));
  EXPECT_THAT(complaint("origin: [1, 2]\n"), HasSubstr("map.yaml:1: expected [x, y, yaw]"));
  EXPECT_THAT(complaint("origin: [1, 2, 0.5]\n"), HasSubstr("map.yaml:1: a rotated origin"));
}

TEST_F(MapYamlTest, TakesFiniteNumbersOnly) {
  EXPECT_THAT(complaint("resolution: inf\n"),
              HasSubstr("map.yaml:1: 'inf' is not a finite number"));
  EXPECT_THAT(complaint("image: a.pgm\norigin: [nan, 0, 0]\n"),
              HasSubstr("map.yaml:2: 'nan' is not a finite number"));
}

TEST_F(MapYamlTest, TakesTheModesThatGoByThresholds) {
  EXPECT_NO_THROW(read("image: a.pgm\nmode: trinary\nresolution: 0.05\n"));
  EXPECT_NO_THROW(read("image: a.pgm\nmode: scale\nresolution: 0.05\n"));
  EXPECT_THAT(complaint("image: a.pgm\nmode: scaled\nresolution: 0.05\n"),
              HasSubstr("map.yaml:2: mode 'scaled' is not supported"));
  EXPECT_THAT(complaint("image: a.pgm\nmode: raw\nresolution: 0.05\n"),
              HasSubstr("map.yaml:2: mode 'raw' is not supported"));
}

TEST_F(MapYamlTest, AsksForImageAndResolution) {
  EXPECT_THAT(complaint("resolution: 0.05\n"), HasSubstr("names no image"));
  EXPECT_THAT(complaint("image: a.pgm\n"), HasSubstr("no resolution"));
}

}  // namespace
}  // namespace echomap::exports

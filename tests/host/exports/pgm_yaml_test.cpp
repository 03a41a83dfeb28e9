// SPDX-License-Identifier: MIT
#include "host/exports/pgm_yaml.hpp"

#include <gtest/gtest.h>

#include "host/exports/pgm_image.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

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
  EXPECT_EQ(read_with("negate: 1\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"), DrawnMap{". ##"});
  EXPECT_EQ(read_with("negate: 0\noccupied_thresh: 0.9\nfree_thresh: 0.25\n"), DrawnMap{"# .."});
}

}  // namespace
}  // namespace echomap::exports

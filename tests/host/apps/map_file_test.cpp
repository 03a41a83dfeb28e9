// SPDX-License-Identifier: MIT
#include "host/apps/map_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/exports/geojson.hpp"
#include "host/exports/pgm_yaml.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::apps {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(MapFile, IsThatOfARunDirectoryOrTheFileItself) {
  const tests::ScratchFolder scratch;
  exports::write_pgm_yaml(scratch / "map.yaml", tests::map_from({"###", "#.#", "###"}));
  EXPECT_EQ(read_map(scratch.path()).columns(), 3);
  EXPECT_EQ(read_map(scratch / "map.yaml").rows(), 3);
}

TEST(MapFile, OfARobotThatFollowedItsWallsIsAllInsideOfItsOutline) {
  const tests::ScratchFolder scratch;
  exports::write_pgm_yaml(scratch / "map.yaml", tests::map_from({"###", "#.#", "###"}));
  const mapping::PolygonMap outline({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}});
  exports::write_outline_geojson(scratch / "outline.geojson", outline);
  files::write_text_file(scratch / "summary.json", R"({"outline_by_strategy": false})");
  EXPECT_EQ(read_map(scratch.path()).columns(), 3);
  files::write_text_file(scratch / "summary.json", R"({"outline_by_strategy": true})");
  const mapping::RasterMap map = read_map(scratch.path());
  EXPECT_EQ(map.state(map.cell_at({1.0, 0.5})), mapping::CellState::kFree);
  EXPECT_EQ(map.state(map.cell_at({1.0, 0.95})), mapping::CellState::kFree);
}

TEST(MapFile, NeedsFloorWhereARobotCouldBe) {
  const tests::ScratchFolder scratch;
  exports::write_pgm_yaml(scratch / "map.yaml", tests::map_from({"## ", "# #", "###"}));
  const auto text = tests::thrown_text<console::CommandError>([&] { read_map(scratch.path()); });
  EXPECT_THAT(text, HasSubstr("no floor"));
  EXPECT_THAT(text, HasSubstr("next: "));
}

TEST(MapFile, SaysWhatAFolderWithoutAMapIsAndWhatToType) {
  const tests::ScratchFolder scratch;
  const auto complaint = [&] {
    return tests::thrown_text<console::CommandError>([&] { read_map(scratch.path()); });
  };
  EXPECT_THAT(complaint(),
              AllOf(HasSubstr("has no map.yaml"), HasSubstr("next: name the one that")));
  files::write_text_file(scratch / "truth_map.yaml", "");
  EXPECT_THAT(complaint(), HasSubstr("or the file " + (scratch / "truth_map.yaml").string()));
}

}  // namespace
}  // namespace echomap::apps

// SPDX-License-Identifier: MIT
#include "host/apps/fleet_map_files.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::apps {
namespace {

TEST(FleetMapFiles, SayWhoHasToldOfEachCell) {
  auto grid = std::make_shared<mapping::OccupancyGrid>();
  const geometry::CellIndex seen_by_both{0, 0};
  const geometry::CellIndex seen_by_second{1, 0};
  grid->add(seen_by_both, -100);
  grid->add(seen_by_second, 100);
  team_map::MergedMap merged;
  merged.robots = {"a.0", "b.0"};
  merged.grid = grid;
  merged.provenance = team_map::Provenance(grid->bounds(), grid->resolution_m());
  merged.provenance.add(seen_by_both, 0);
  merged.provenance.add(seen_by_both, 1);
  merged.provenance.add(seen_by_second, 1);
  const tests::ScratchFolder folder;
  save_provenance(merged, folder / "provenance.csv");
  EXPECT_EQ(files::read_text_file(folder / "provenance.csv"),
            "x_m,y_m,robots\n0.025,0.025,a.0+b.0\n0.075,0.025,b.0\n");
}

}  // namespace
}  // namespace echomap::apps

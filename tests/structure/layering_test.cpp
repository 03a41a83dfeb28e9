// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/structure/layer_table.hpp"
#include "tests/structure/source_tree.hpp"
#include "tests/structure/tree_root.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::structure {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

/// The table of docs/architecture.md. It stands here a second time on purpose: a new arrow between
/// two folders is a decision and has to be written down twice.
const LayerRules rules{
    {"protocol", {}},
    {"firmware/hal", {}},
    {"firmware/drivers", {"firmware/hal", "protocol"}},
    {"firmware/control", {"firmware/drivers"}},
    {"firmware/tasks", {"firmware/control"}},
    {"firmware/app", {"firmware/tasks"}},
    {"firmware/boards", {"firmware/hal", "protocol"}},
    {"firmware/boards/native",
     {"firmware/hal", "protocol", "firmware/app", "firmware/boards/edge_counter"}},
    {"host/time", {}},
    {"host/geometry", {}},
    {"host/optimization", {}},
    {"host/files", {}},
    {"host/mcap", {"host/files"}},
    {"host/ros_messages", {}},
    {"host/transport", {"host/time"}},
    {"host/robot_link", {"protocol", "host/time", "host/transport"}},
    {"host/sensors", {"protocol", "host/time", "host/geometry"}},
    {"host/datasets",
     {"host/files", "host/mcap", "host/ros_messages", "host/geometry", "host/sensors"}},
    {"host/models", {"host/geometry", "host/sensors"}},
    {"host/mapping", {"host/geometry", "host/optimization", "host/sensors", "host/models"}},
    {"host/localization", {"host/geometry", "host/models", "host/mapping"}},
    {"host/slam",
     {"host/geometry", "host/optimization", "host/models", "host/mapping", "host/localization"}},
    {"host/pipeline", {"host/datasets", "host/localization", "host/mapping", "host/slam"}},
    {"host/recording",
     {"host/mcap",
      "host/ros_messages",
      "host/geometry",
      "host/sensors",
      "host/mapping",
      "host/localization",
      "host/pipeline"}},
    {"host/exploration", {"host/geometry", "host/sensors", "host/mapping", "host/pipeline"}},
    {"host/diagnosis",
     {"host/geometry", "host/sensors", "host/mapping", "host/pipeline", "host/exploration"}},
    {"host/exports",
     {"host/files", "host/geometry", "host/sensors", "host/mapping", "host/pipeline"}},
    {"host/paper_report", {"host/files", "host/exports"}},
    {"host/evaluation",
     {"host/geometry", "host/sensors", "host/mapping", "host/pipeline", "host/exports"}},
    {"host/console", {}},
    {"host/boards", {"protocol", "host/files", "host/console"}},
    {"host/session",
     {"host/files",
      "host/boards",
      "host/transport",
      "host/console",
      "host/robot_link",
      "host/pipeline",
      "host/recording",
      "host/exploration",
      "host/diagnosis"}},
    {"host/strategies", {"host/session"}},
    {"host/tracking", {"host/strategies"}},
    {"host/flashing", {"host/session"}},
    {"host/terminal_view", {"host/geometry", "host/mapping", "host/console"}},
    {"host/live_page", {"host/tracking"}},
    {"host/mqtt", {}},
    {"host/broker", {"host/mqtt", "host/session"}},
    {"host/team_map", {"host/optimization", "host/mapping", "host/slam", "host/pipeline"}},
    {"host/team_exploration", {"host/exploration", "host/team_map"}},
    {"host/source_search", {"host/exploration"}},
    {"host/fleet_messages",
     {"host/files", "host/mqtt", "host/team_map", "host/team_exploration", "host/source_search"}},
    {"host/fleet", {"host/fleet_messages"}},
    {"host/fleet_member", {"host/fleet", "host/session"}},
    {"host/papers",
     {"host/evaluation",
      "host/localization",
      "host/paper_report",
      "host/session",
      "hil_mock/world"}},
    {"host/apps", {"host"}},
    {"hil_mock/world", {"host/geometry", "host/files"}},
    {"hil_mock/line_faults", {"hil_mock/world"}},
    {"hil_mock/runner", {"hil_mock/world", "hil_mock/line_faults"}},
    {"hil_mock/mock_device", {"hil_mock/runner", "firmware", "protocol"}},
    {"hil_mock/emulator", {"hil_mock/runner", "protocol"}},
    {"hil_mock/ev3", {"hil_mock/runner", "protocol"}},
    {"hil_mock/unicorn", {"hil_mock/runner", "protocol"}},
    {"hil_mock/rp2040", {"hil_mock/runner", "protocol"}},
};

TEST(Layering, EveryIncludeOfTheTreeIsPermitted) {
  EXPECT_THAT(LayerTable(rules).violations_in(read_source_tree(tree_root)), IsEmpty());
}

TEST(Layering, TheTableEqualsTheOneInTheDocument) {
  EXPECT_EQ(read_layer_rules(read_lines(tree_root / "docs/architecture.md")), rules);
}

TEST(Layering, TheTableHasNoCycle) {
  const LayerTable table(rules);
  for (const auto& [upper, upper_may] : rules) {
    for (const auto& [lower, lower_may] : rules) {
      if (upper != lower && !is_below(upper, lower) && !is_below(lower, upper)) {
        EXPECT_FALSE(table.permits(upper, lower + "/x.hpp") &&
                     table.permits(lower, upper + "/x.hpp"))
            << upper << " and " << lower;
      }
    }
  }
}

TEST(Layering, PermitsWhatAListedFolderMayInclude) {
  const LayerTable table(rules);
  EXPECT_TRUE(table.permits("host/pipeline", "host/geometry/angle.hpp"));
  EXPECT_TRUE(table.permits("firmware/tasks", "firmware/hal/clock.hpp"));
  EXPECT_TRUE(table.permits("host/apps", "host/exports/csv.hpp"));
  EXPECT_TRUE(table.permits("firmware/boards/native", "firmware/control/scan_sweep.hpp"));
  EXPECT_FALSE(table.permits("firmware/boards", "firmware/control/scan_sweep.hpp"));
  EXPECT_FALSE(table.permits("host/mapping", "host/pipeline/snapshot.hpp"));
  EXPECT_FALSE(table.permits("hil_mock/emulator", "firmware/app/robot.hpp"));
}

// --- a copy of the tree with one violation planted in it

class PlantedViolation : public testing::Test {
 protected:
  void SetUp() override {
    for (const std::string& folder : source_folders) {
      fs::copy(tree_root / folder, copy_ / folder, fs::copy_options::recursive);
    }
  }

  std::vector<std::string> violations_after(const std::string& path, const std::string& text) {
    fs::create_directories((copy_ / path).parent_path());
    std::ofstream(copy_ / path) << text << '\n';
    return LayerTable(rules).violations_in(read_source_tree(copy_.path()));
  }

 private:
  const tests::ScratchFolder copy_;
};

TEST_F(PlantedViolation, UpwardIsCaught) {
  EXPECT_THAT(
      violations_after("host/time/planted.hpp",
                       "#pragma once\n#include \"host/geometry/angle.hpp\""),
      testing::Contains(
          "host/time/planted.hpp:2: host/geometry/angle.hpp: host/time may not include it"));
}

TEST_F(PlantedViolation, UpwardUnderAConditionIsCaught) {
  EXPECT_THAT(violations_after("protocol/planted.cpp",
                               "#ifdef NEVER\n #  include \"host/time/host_time.hpp\"\n#endif"),
              testing::Contains(HasSubstr("protocol may not include it")));
}

TEST_F(PlantedViolation, ProductionThatIncludesATestIsCaught) {
  EXPECT_THAT(violations_after("host/geometry/planted.cpp",
                               "#include \"tests/support/golden_vectors.hpp\""),
              testing::Contains(HasSubstr("host/geometry may not include it")));
}

TEST_F(PlantedViolation, AFolderWithoutARuleIsCaught) {
  EXPECT_THAT(violations_after("host/planted/planted.cpp", "#include \"protocol/cobs.hpp\""),
              testing::Contains(HasSubstr("no rule for this folder")));
}

TEST_F(PlantedViolation, APathThatIsNotTheTreesIsCaught) {
  EXPECT_THAT(violations_after("protocol/planted.cpp", "#include \"cobs.hpp\""),
              testing::Contains(HasSubstr("no such path in this tree")));
}

TEST_F(PlantedViolation, AnOwnFileInAngleBracketsIsCaught) {
  EXPECT_THAT(violations_after("host/time/planted.cpp", "#include <host/geometry/angle.hpp>"),
              testing::Contains(HasSubstr("in quotes")));
}

}  // namespace
}  // namespace echomap::structure

// SPDX-License-Identifier: MIT
#include "hil_mock/world/floor_plan_file.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/bundled_files.hpp"

namespace echomap::world {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string room_text = R"(name = "small"
[start]
x_m = 0.5
y_m = 0.5
heading_deg = 90
[room]
corners_m = [[0, 0], [2, 0], [2, 1], [0, 1]]
[[room.side]]
index = 1
material = "rough"
[[obstacle]]
name = "box"
corners_m = [[1, 0.2], [1.2, 0.2], [1.2, 0.5]]
)";

std::string edited(std::string from, const std::string& to) {
  std::string text = room_text;
  return text.replace(text.find(from), from.size(), to);
}

std::string error_of(const std::string& text) {
  try {
    read_floor_plan(files::TomlReader::parse(text, "small.toml"));
  } catch (const files::ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(FloorPlanFile, ReadsRoomObstaclesMaterialsAndStart) {
  const FloorPlan plan = read_floor_plan(files::TomlReader::parse(room_text, "small.toml"));
  EXPECT_EQ(plan.name(), "small");
  ASSERT_EQ(plan.walls().size(), 7U);
  EXPECT_EQ(plan.walls()[0].material, Material::kSmooth);
  EXPECT_EQ(plan.walls()[1].material, Material::kRough);
  EXPECT_EQ(plan.obstacles_m().size(), 1U);
  EXPECT_NEAR(plan.T_world_start().heading_rad(), 1.5708, 1e-4);
}

TEST(FloorPlanFile, NamesThePlaceOfEveryFault) {
  EXPECT_EQ(error_of(room_text), "no error");
  EXPECT_THAT(error_of(edited("[2, 1], [0, 1]", "[0, 1], [2, 1]")),
              StartsWith("small.toml:7:13: sides 1 and 3 cross"));
  EXPECT_THAT(error_of(edited("[1.2, 0.5]", "[1.2, 5]")), StartsWith("small.toml:13:13: "));
  EXPECT_THAT(error_of(edited("[2, 1], [0, 1]", "[2, 1000], [0, 1000]")),
              StartsWith("small.toml:7:13: a corner is more than 100 m away"));
  EXPECT_THAT(error_of(edited("x_m = 0.5", "x_m = 2.5")), StartsWith("small.toml:3:7: start: "));
  EXPECT_THAT(error_of(edited("index = 1", "index = 4")),
              StartsWith("small.toml:9:9: sides are numbered 0 to 3"));
}

TEST(FloorPlanFile, SuggestsTheNearestValidKeyAndMaterial) {
  const std::string unknown = error_of(edited("index = 1", "index = 1\nmateriall = \"rough\""));
  EXPECT_THAT(unknown, StartsWith("small.toml:10:1: "));
  EXPECT_THAT(unknown, HasSubstr("material"));
  EXPECT_THAT(error_of(edited("\"rough\"", "\"rouhg\"")), HasSubstr("did you mean 'rough'"));
}

class BundledWorld : public testing::TestWithParam<const char*> {};

TEST_P(BundledWorld, IsAValidRoomWithSpaceForTheRobot) {
  const auto path = files::bundled_file(GetParam(), "hil_mock/worlds", "world");
  const FloorPlan plan = read_floor_plan(files::TomlReader::load(path));
  EXPECT_EQ(plan.name(), GetParam());
  EXPECT_GT(plan.clearance_m(plan.T_world_start().position_m()), 0.2);
}

INSTANTIATE_TEST_SUITE_P(All,
                         BundledWorld,
                         testing::Values("living_room", "empty_room", "corridor", "l_room"));

}  // namespace
}  // namespace echomap::world

// SPDX-License-Identifier: MIT
#include "hil_mock/world/floor_plan_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hil_mock/world/floor_contact.hpp"
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

std::string plan_error_of(const std::string& text) {
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
  EXPECT_EQ(plan.walls()[0].surface.material, Material::kSmooth);
  EXPECT_EQ(plan.walls()[1].surface.material, Material::kRough);
  EXPECT_EQ(plan.obstacles_m().size(), 1U);
  EXPECT_NEAR(plan.T_world_start().heading_rad(), 1.5708, 1e-4);
}

TEST(FloorPlanFile, NamesThePlaceOfEveryFault) {
  EXPECT_EQ(plan_error_of(room_text), "no error");
  EXPECT_THAT(plan_error_of(edited("[2, 1], [0, 1]", "[0, 1], [2, 1]")),
              StartsWith("small.toml:7:13: sides 1 and 3 cross"));
  EXPECT_THAT(plan_error_of(edited("[1.2, 0.5]", "[1.2, 5]")), StartsWith("small.toml:13:13: "));
  EXPECT_THAT(plan_error_of(edited("[2, 1], [0, 1]", "[2, 1000], [0, 1000]")),
              StartsWith("small.toml:7:13: a corner is more than 100 m away"));
  EXPECT_THAT(plan_error_of(edited("x_m = 0.5", "x_m = 2.5")),
              StartsWith("small.toml:3:7: start: "));
  EXPECT_THAT(plan_error_of(edited("index = 1", "index = 4")),
              StartsWith("small.toml:9:9: sides are numbered 0 to 3"));
}

TEST(FloorPlanFile, SuggestsTheNearestValidKeyAndMaterial) {
  const std::string unknown =
      plan_error_of(edited("index = 1", "index = 1\nmateriall = \"rough\""));
  EXPECT_THAT(unknown, StartsWith("small.toml:10:1: "));
  EXPECT_THAT(unknown, HasSubstr("material"));
  EXPECT_THAT(plan_error_of(edited("\"rough\"", "\"rouhg\"")), HasSubstr("did you mean 'rough'"));
}

const std::string marks_text = R"([[hole]]
name = "stairs"
corners_m = [[1.5, 0], [2, 0], [2, 1], [1.5, 1]]
[[virtual_wall]]
x_m = 0.0
y_m = 0.8
heading_deg = -90
length_m = 0.7
beam_half_angle_deg = 5
)";

std::string edited_marks(const std::string& from, const std::string& to) {
  std::string text = room_text + marks_text;
  return text.replace(text.rfind(from), from.size(), to);
}

TEST(FloorPlanFile, ReadsHolesVirtualWallsAndReflectance) {
  const FloorPlan plan = read_floor_plan(files::TomlReader::parse(
      edited_marks("\"rough\"", "\"rough\"\nreflectance = 0.4"), "small.toml"));
  EXPECT_TRUE(plan.is_hole({1.7, 0.5}));
  ASSERT_EQ(plan.virtual_walls().size(), 1U);
  EXPECT_NEAR(plan.virtual_walls()[0].heading_rad, -1.5708, 1e-4);
  EXPECT_DOUBLE_EQ(plan.virtual_walls()[0].length_m, 0.7);
  EXPECT_DOUBLE_EQ(plan.walls()[1].surface.reflectance, 0.4);
  EXPECT_DOUBLE_EQ(plan.walls()[0].surface.reflectance, 0.9);
}

TEST(FloorPlanFile, NamesThePlaceOfABadHoleOrVirtualWall) {
  EXPECT_EQ(plan_error_of(room_text + marks_text), "no error");
  EXPECT_THAT(plan_error_of(edited_marks("[2, 1], [1.5, 1]", "[2, 1], [1.5, 2]")),
              StartsWith("small.toml:16:13: the hole is not inside of the room"));
  EXPECT_THAT(plan_error_of(edited_marks("[2, 1], [1.5, 1]", "[1.5, 1], [2, 1]")),
              StartsWith("small.toml:16:13: sides "));
  EXPECT_THAT(plan_error_of(edited_marks("y_m = 0.8", "y_m = 1.8")),
              StartsWith("small.toml:18:7: "));
  EXPECT_THAT(plan_error_of(edited_marks("length_m = 0.7", "length_m = 0")),
              StartsWith("small.toml:21:12: it must be positive"));
  EXPECT_THAT(plan_error_of(edited_marks("beam_half_angle_deg", "beam_half_angel_deg")),
              HasSubstr("has 'beam_half_angel_deg'"));
  EXPECT_THAT(plan_error_of(edited_marks("\"rough\"", "\"rough\"\nreflectance = 1.4")),
              StartsWith("small.toml:11:15: it must be between 0 and 1"));
  EXPECT_THAT(plan_error_of(edited_marks("[1.5, 0], [2, 0], [2, 1], [1.5, 1]",
                                         "[0.4, 0.4], [0.6, 0.4], [0.6, 0.6], [0.4, 0.6]")),
              StartsWith("small.toml:3:7: start: "));
}

class BundledWorld : public testing::TestWithParam<const char*> {
 protected:
  FloorPlan load() const {
    const auto path = files::bundled_file(GetParam(), "hil_mock/worlds", "world");
    return read_floor_plan(files::TomlReader::load(path));
  }
};

TEST_P(BundledWorld, IsAValidRoomWithSpaceForTheRobot) {
  const FloorPlan plan = load();
  EXPECT_EQ(plan.name(), GetParam());
  EXPECT_GT(plan.clearance_m(plan.T_world_start().position_m()), 0.2);
}

/// Places, points of a lattice, that a disc can be moved to from the start with so much room round
/// its middle.
std::vector<Eigen::Vector2d> reachable_m(const FloorPlan& plan, double clearance_m, double step_m) {
  std::set<std::pair<int, int>> seen;
  std::vector<std::pair<int, int>> open{{0, 0}};
  std::vector<Eigen::Vector2d> reached_m;
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    const Eigen::Vector2d place_m =
        plan.T_world_start().position_m() + step_m * Eigen::Vector2d(x, y);
    if (!seen.insert({x, y}).second || !plan.is_free(place_m) ||
        plan.clearance_m(place_m) < clearance_m || hole_distance_m(plan, place_m) < clearance_m) {
      continue;
    }
    reached_m.push_back(place_m);
    open.insert(open.end(), {{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}});
  }
  return reached_m;
}

/// Places by squares of a side, to find those within that side.
class PlacesBySquare {
 public:
  PlacesBySquare(const std::vector<Eigen::Vector2d>& places_m, double side_m) : side_m_(side_m) {
    for (const Eigen::Vector2d& place_m : places_m) {
      squares_[square_of(place_m)].push_back(place_m);
    }
  }

  bool has_one_near(const Eigen::Vector2d& place_m) const {
    const auto [x, y] = square_of(place_m);
    for (int i = 0; i < 9; ++i) {
      const auto found = squares_.find({x + i % 3 - 1, y + i / 3 - 1});
      if (found != squares_.end() &&
          std::any_of(found->second.begin(), found->second.end(), [&](const auto& one) {
            return (one - place_m).norm() < side_m_;
          })) {
        return true;
      }
    }
    return false;
  }

 private:
  std::pair<int, int> square_of(const Eigen::Vector2d& place_m) const {
    return {static_cast<int>(std::floor(place_m.x() / side_m_)),
            static_cast<int>(std::floor(place_m.y() / side_m_))};
  }

  double side_m_;
  std::map<std::pair<int, int>, std::vector<Eigen::Vector2d>> squares_;
};

TEST_P(BundledWorld, HasNoGapThatIsJustWideEnough) {
  if (GetParam() == std::string("office")) {
    GTEST_SKIP() << "its armchair leaves 0.2 m to the wall";
  }
  const double radius_m = GetParam() == std::string("epuck_field") ? 0.037 : 0.09;
  const FloorPlan plan = load();
  const PlacesBySquare with_room(reachable_m(plan, 1.2 * radius_m, 0.25 * radius_m),
                                 2.0 * radius_m);
  for (const Eigen::Vector2d& place_m : reachable_m(plan, 0.9 * radius_m, 0.5 * radius_m)) {
    ASSERT_TRUE(with_room.has_one_near(place_m))
        << "only a robot that scrapes its way in gets to " << place_m.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(All,
                         BundledWorld,
                         testing::Values("living_room",
                                         "empty_room",
                                         "corridor",
                                         "l_room",
                                         "landing",
                                         "office",
                                         "epuck_field",
                                         "playground",
                                         "nxt_room",
                                         "create_l",
                                         "create_t",
                                         "corridor_rooms",
                                         "round_room",
                                         "pillar_hall",
                                         "classroom",
                                         "garage",
                                         "attic",
                                         "studio",
                                         "hall",
                                         "corridor_t",
                                         "ward",
                                         "source_hall",
                                         "source_rooms"));

const std::string source_text = R"([[source]]
x_m = 0.4
y_m = 0.7
strength = 20
[[source]]
kind = "light"
x_m = 1.8
y_m = 0.2
strength = 500
height_m = 2
)";

TEST(FloorPlanFile, ReadsSourcesBackgroundsAndWhatShields) {
  std::string text = "background_per_s = 0.4\nambient_lux = 30\n" +
                     edited("material = \"rough\"", "material = \"rough\"") + source_text;
  text.replace(text.find("[[obstacle]]"), 12, "[[obstacle]]\nattenuation_per_m = 125");
  const FloorPlan plan = read_floor_plan(files::TomlReader::parse(text, "small.toml"));
  ASSERT_EQ(plan.sources().size(), 2U);
  EXPECT_EQ(plan.sources()[0].kind, SourceKind::kRadiation);
  EXPECT_EQ(plan.sources()[0].position_m, Eigen::Vector2d(0.4, 0.7));
  EXPECT_EQ(plan.sources()[0].strength, 20.0);
  EXPECT_EQ(plan.sources()[0].height_m, 0.1);
  EXPECT_EQ(plan.sources()[1].kind, SourceKind::kLight);
  EXPECT_EQ(plan.sources()[1].height_m, 2.0);
  EXPECT_EQ(plan.backgrounds().radiation_per_s, 0.4);
  EXPECT_EQ(plan.backgrounds().light_lux, 30.0);
  EXPECT_EQ(plan.room_attenuation_per_m(), kConcretePerM);
  EXPECT_EQ(plan.attenuations_per_m(), std::vector<double>{125.0});
}

TEST(FloorPlanFile, NamesThePlaceOfABadSource) {
  const auto error_after = [](const std::string& from, const std::string& to) {
    std::string text = room_text + source_text;
    return plan_error_of(text.replace(text.find(from), from.size(), to));
  };
  EXPECT_EQ(plan_error_of(room_text + source_text), "no error");
  EXPECT_THAT(error_after("x_m = 0.4", "x_m = 4.0"),
              HasSubstr("the source is not inside of the room"));
  EXPECT_THAT(error_after("strength = 20", "strength = 0"), HasSubstr("it must be positive"));
  EXPECT_THAT(error_after("\"light\"", "\"ligth\""), HasSubstr("did you mean 'light'"));
}

const std::string person_text = R"([[person]]
path_m = [[-0.5, 0.5], [2.5, 0.5]]
speed_m_per_s = 0.8
radius_m = 0.2
start_s = 12
)";

std::string edited_person(std::string from, const std::string& to) {
  std::string text = room_text + person_text;
  return text.replace(text.rfind(from), from.size(), to);
}

TEST(FloorPlanFile, ReadsPeopleAndGlass) {
  const FloorPlan plan = read_floor_plan(
      files::TomlReader::parse(edited_person("\"rough\"", "\"glass\""), "small.toml"));
  EXPECT_EQ(plan.walls()[1].surface.material, Material::kGlass);
  ASSERT_EQ(plan.people().size(), 1U);
  EXPECT_EQ(plan.people()[0].path_m[1], Eigen::Vector2d(2.5, 0.5));
  EXPECT_EQ(plan.people()[0].speed_m_per_s, 0.8);
  EXPECT_EQ(plan.people()[0].radius_m, 0.2);
  EXPECT_EQ(plan.people()[0].start_s, 12.0);
}

TEST(FloorPlanFile, NamesThePlaceOfABadPerson) {
  EXPECT_EQ(plan_error_of(room_text + person_text), "no error");
  EXPECT_THAT(plan_error_of(edited_person(", [2.5, 0.5]", "")),
              StartsWith("small.toml:15:10: a path takes two points or more"));
  EXPECT_THAT(plan_error_of(edited_person("[2.5, 0.5]", "[250, 0.5]")),
              StartsWith("small.toml:15:10: a point is more than 100 m away"));
  EXPECT_THAT(plan_error_of(edited_person("0.8", "0")),
              StartsWith("small.toml:16:17: it must be positive"));
  EXPECT_THAT(plan_error_of(edited_person("radius_m = 0.2", "radius_m = -0.2")),
              StartsWith("small.toml:17:12: it must be positive"));
  EXPECT_THAT(plan_error_of(edited_person("start_s = 12", "start_s = -1")),
              StartsWith("small.toml:18:11: it must be between 0 and"));
  EXPECT_THAT(plan_error_of(edited_person("speed_m_per_s", "sped_m_per_s")),
              HasSubstr("sped_m_per_s"));
}

}  // namespace
}  // namespace echomap::world

// SPDX-License-Identifier: MIT
#include "host/files/toml_reader.hpp"

#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::files {
namespace {

using ::testing::HasSubstr;

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(TomlReader, ReadsEveryKind) {
  const auto toml = TomlReader::parse(
      "width_m = 4\nname = 'room'\ncorners = [[0, 0], [1.5, 2]]\n[wall]\nrough = true\n"
      "[[box]]\nside_m = 0.5\n[[box]]\nside_m = 0.7\n",
      "room.toml");
  EXPECT_EQ(toml.number("width_m"), 4.0);
  EXPECT_EQ(toml.integer("width_m"), 4);
  EXPECT_EQ(toml.text("name"), "room");
  EXPECT_EQ(toml.points("corners").at(1)[1], 2.0);
  EXPECT_TRUE(toml.table("wall").boolean_or("rough", false));
  EXPECT_EQ(toml.tables("box").at(0).number("side_m"), 0.5);
  EXPECT_EQ(toml.tables("box").at(1).number("side_m"), 0.7);
  EXPECT_EQ(toml.number_or("height_m", 2.5), 2.5);
  EXPECT_NO_THROW(toml.reject_unknown_keys());
}

TEST(TomlReader, PlacesASyntaxError) {
  const auto error = error_of([] { TomlReader::parse("a = 1\nb = = 2\n", "room.toml"); });
  EXPECT_THAT(error, HasSubstr("room.toml:2:5: "));
}

TEST(TomlReader, PlacesAWrongType) {
  const auto toml = TomlReader::parse("a = 1\nwidth_m = 'wide'\n", "room.toml");
  EXPECT_EQ(error_of([&] { toml.number("width_m"); }),
            "room.toml:2:11: 'width_m' must be a finite number");
}

TEST(TomlReader, RefusesNumbersThatAreNotFinite) {
  const auto toml = TomlReader::parse("a = nan\nb = inf\np = [[0, inf]]\n", "room.toml");
  EXPECT_THROW(toml.number("a"), ConfigError);
  EXPECT_THROW(toml.number("b"), ConfigError);
  EXPECT_THROW(toml.points("p"), ConfigError);
}

TEST(TomlReader, NamesAMissingKeyAtItsTable) {
  const auto toml = TomlReader::parse("\n[wall]\nrough = true\n", "room.toml");
  EXPECT_THAT(error_of([&] { toml.table("wall").number("height_m"); }),
              HasSubstr("room.toml:2:1: 'height_m' is missing"));
}

TEST(TomlReader, HintsAtTheKeyThatLooksLikeAMissingOne) {
  const auto toml = TomlReader::parse("[wall]\nheight_stddev = 0.1\nheigth_m = 2.5\n", "room.toml");
  EXPECT_EQ(error_of([&] { toml.table("wall").number("height_m"); }),
            "room.toml:1:1: 'height_m' is missing; line 3 has 'heigth_m'");
}

TEST(TomlReader, NamesTheNearestKeyForAnUnknownOne) {
  const auto toml = TomlReader::parse("[wall]\nheigth_m = 2.5\n", "room.toml");
  toml.table("wall").number_or("height_m", 1.0);
  EXPECT_THAT(error_of([&] { toml.reject_unknown_keys(); }),
              HasSubstr("room.toml:2:1: unknown key 'heigth_m'; did you mean 'height_m'?"));
}

TEST(TomlReader, ListsTheValidKeysWhereNoneIsNear) {
  const auto toml = TomlReader::parse("colour = 1\n", "room.toml");
  toml.number_or("x_m", 0);
  EXPECT_THAT(error_of([&] { toml.reject_unknown_keys(); }), HasSubstr("valid here: x_m"));
}

TEST(TomlReader, NamesAFileThatCannotBeRead) {
  EXPECT_THAT(error_of([] { TomlReader::load("/nowhere/room.toml"); }),
              HasSubstr("/nowhere/room.toml: No such file"));
}

}  // namespace
}  // namespace echomap::files

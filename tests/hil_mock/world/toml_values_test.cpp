// SPDX-License-Identifier: MIT
#include "hil_mock/world/toml_values.hpp"

#include <functional>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

namespace echomap::world {
namespace {

files::TomlReader reader() {
  return files::TomlReader::parse("good = 2\nzero = 0\nnegative = -1\nturn = 90", "a.toml");
}

std::string error_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const files::ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(TomlValues, PositiveNamesThePlaceOfAZero) {
  EXPECT_DOUBLE_EQ(positive(reader(), "good"), 2.0);
  EXPECT_EQ(error_of([] { positive(reader(), "zero"); }), "a.toml:2:8: it must be positive");
}

TEST(TomlValues, WithinHasBoundsAndAFallback) {
  EXPECT_DOUBLE_EQ(within(reader(), "good", 1.0, 2.0), 2.0);
  EXPECT_DOUBLE_EQ(within(reader(), "absent", 1.0, 2.0), 1.0);
  EXPECT_EQ(error_of([] { within(reader(), "negative", 1.0, 2.0); }).rfind("a.toml:3:12: ", 0), 0U);
  EXPECT_EQ(error_of([] { within(reader(), "good", 1.0, 1.9); }).rfind("a.toml:1:8: ", 0), 0U);
}

TEST(TomlValues, AnglesAreInDegrees) {
  EXPECT_DOUBLE_EQ(angle(reader(), "turn", 0.0), 0.5 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(angle(reader(), "absent", 0.25), 0.25);
}

}  // namespace
}  // namespace echomap::world

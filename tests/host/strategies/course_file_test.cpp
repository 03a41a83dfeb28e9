// SPDX-License-Identifier: MIT
#include "host/strategies/course_file.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::strategies {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string playground = ECHOMAP_SOURCE_DIR "/host/courses/playground.toml";

/// Reads the bundled playground with `from` replaced by `to` and answers the error.
std::string error_with(const std::string& from, const std::string& to) {
  std::string text = files::read_text_file(playground);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  try {
    read_course(files::TomlReader::parse(text, "course.toml"));
  } catch (const files::ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(CourseFile, HasThePapersGridAndItsSevenPhases) {
  const auto course = load_course("playground");
  EXPECT_EQ(course.name, "playground");
  EXPECT_EQ(course.cells.columns(), 56);
  EXPECT_EQ(course.cells.rows(), 44);
  EXPECT_EQ(course.cell_m, 0.05);
  ASSERT_EQ(course.waypoints.size(), 7U);
  EXPECT_EQ(course.waypoints.back().position_m, course.T_course_start.position_m());
  EXPECT_EQ(course.known_walls.size(), 5U);
}

TEST(CourseFile, NamesThePlaceOfWhatIsWrong) {
  EXPECT_THAT(error_with("columns = 56", "columns = 0"),
              StartsWith("course.toml:7:11: 'columns' must be from 1 to 2000"));
  EXPECT_THAT(error_with("rows = 44", "rows = 44.5"), StartsWith("course.toml:8:"));
  EXPECT_THAT(error_with("cell_m = 0.05", "cell_m = -1"), HasSubstr("greater than zero"));
  EXPECT_THAT(error_with("x_m = 2.47", "x_m = 24.7"),
              HasSubstr("(24.7, 0.475) is not on the grid"));
  EXPECT_THAT(error_with("y_m = 1.075", "y_n = 1.075"), HasSubstr("y_m"));
  EXPECT_THAT(error_with("points_m = [[0.65, 0.825], [0.65, 0.225], [2.72, 0.225], [2.72, 1.975], "
                         "[0.65, 1.975], [0.65, 1.325]]",
                         "points_m = [[0.65, 0.825]]"),
              HasSubstr("two points"));
  EXPECT_THAT(error_with("[[known_wall]]", "[[known_walls]]"), HasSubstr("known_wall"));
}

TEST(CourseFile, HasAWaypoint) {
  const std::string text =
      "name = \"x\"\n[grid]\ncolumns = 9\nrows = 9\ncell_m = 0.1\n"
      "[start]\nx_m = 0.5\ny_m = 0.5\nheading_deg = 0\n";
  EXPECT_THROW(read_course(files::TomlReader::parse(text, "x")), files::ConfigError);
}

TEST(CourseFile, NamesTheNearestBundledOne) {
  try {
    load_course("playgruond");
    FAIL();
  } catch (const files::ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("playground"));
  }
}

}  // namespace
}  // namespace echomap::strategies

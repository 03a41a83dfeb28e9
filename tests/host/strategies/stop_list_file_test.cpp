// SPDX-License-Identifier: MIT
#include "host/strategies/stop_list_file.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/thrown_text.hpp"

namespace echomap::strategies {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::vector<exploration::TourPlace> read(const std::string& text) {
  return read_stop_list(files::TomlReader::parse(text, "stops.toml"));
}

std::string error_of(const std::string& text) {
  return tests::thrown_text<files::ConfigError>([&] { read(text); });
}

TEST(StopListFile, ReadsPlacesInTheirOrder) {
  const auto places = read(R"([[place]]
name = "window"
x_m = 1
y_m = -0.5
[[place]]
x_m = 2.0
y_m = 0.0
sweep = false
)");
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0].name, "window");
  EXPECT_EQ(places[0].position_m, Eigen::Vector2d(1.0, -0.5));
  EXPECT_TRUE(places[0].sweeps);
  EXPECT_EQ(places[1].name, "");
  EXPECT_FALSE(places[1].sweeps);
}

TEST(StopListFile, NamesThePlaceOfWhatIsWrong) {
  EXPECT_THAT(error_of(""), HasSubstr("one [[place]] or more"));
  EXPECT_THAT(error_of("[[place]]\nx_m = 1\n"), HasSubstr("y_m"));
  EXPECT_THAT(error_of("[[place]]\nx_m = 1\ny_m = 2\nsweeps = true\n"),
              StartsWith("stops.toml:4:1: "));
  EXPECT_THAT(error_of("[[place]]\nx_m = 1000\ny_m = 2\n"),
              StartsWith("stops.toml:2:7: 'x_m' must be from -100 to 100"));
}

TEST(StopListFile, SaysWhichFileIsNotThere) {
  EXPECT_THAT(tests::thrown_text<files::ConfigError>([] { load_stop_list("no_such_file.toml"); }),
              HasSubstr("no_such_file.toml"));
}

}  // namespace
}  // namespace echomap::strategies

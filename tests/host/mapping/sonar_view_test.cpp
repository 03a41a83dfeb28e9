// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_view.hpp"

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

PlacedReading reading_at(double x_m, double bearing_rad, std::optional<double> range_m) {
  return {{x_m, 0.0, 0.0}, {x_m, 0.0, bearing_rad}, range_m};
}

TEST(SonarView, TakesReadingsOfOnePlaceTogether) {
  const auto views = views_of(
      {reading_at(0.0, 0.0, 1.0), reading_at(0.01, 0.5, 2.0), reading_at(0.5, 0.0, 1.0)}, 0.03);
  ASSERT_EQ(views.size(), 2U);
  EXPECT_EQ(views[0].beams.size(), 2U);
  EXPECT_EQ(views[1].origin_m.x(), 0.5);
}

TEST(SonarView, KeepsTheMiddleOfRepeatedReadings) {
  const auto views = views_of(
      {reading_at(0.0, 0.2, 1.0), reading_at(0.0, 0.2, std::nullopt), reading_at(0.0, 0.2, 1.1)},
      0.03);
  ASSERT_EQ(views.size(), 1U);
  ASSERT_EQ(views[0].beams.size(), 1U);
  EXPECT_EQ(views[0].beams[0].range_m, 1.1);
}

TEST(SonarView, FindsNoneWithoutReadings) { EXPECT_TRUE(views_of({}, 0.03).empty()); }

}  // namespace
}  // namespace echomap::mapping

// SPDX-License-Identifier: MIT
#include "host/sensors/infrared_curve.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::sensors {
namespace {

/// counts = 1000 (1 cm / range)^2.
const InfraredCurve& inverse_square() {
  static const InfraredCurve curve({{1000.0, 0.01}, {10.0, 0.10}});
  return curve;
}

TEST(InfraredCurve, IsAPowerLawBetweenTwoPoints) {
  EXPECT_NEAR(inverse_square().range_m(250.0).value(), 0.02, 1e-12);
  EXPECT_NEAR(inverse_square().range_m(40.0).value(), 0.05, 1e-12);
}

TEST(InfraredCurve, MeetsEachOfItsPoints) {
  const InfraredCurve curve({{818, 0.005}, {512, 0.010}, {102, 0.030}});
  EXPECT_NEAR(curve.range_m(818).value(), 0.005, 1e-12);
  EXPECT_NEAR(curve.range_m(512).value(), 0.010, 1e-12);
  EXPECT_NEAR(curve.range_m(102).value(), 0.030, 1e-12);
}

TEST(InfraredCurve, FallsWithTheCountsAllTheWay) {
  const InfraredCurve curve({{818, 0.005}, {512, 0.010}, {315, 0.015}, {28, 0.06}});
  double last_m = 1.0;
  for (int counts = 28; counts <= 1023; ++counts) {
    const double range_m = curve.range_m(counts).value();
    EXPECT_LE(range_m, last_m);
    last_m = range_m;
  }
}

TEST(InfraredCurve, SeesNothingBelowItsLastPointAndNoNearerThanItsFirst) {
  EXPECT_FALSE(inverse_square().range_m(9.9));
  EXPECT_EQ(inverse_square().range_m(1023.0), 0.01);
  EXPECT_EQ(inverse_square().max_m(), 0.10);
}

TEST(InfraredCurve, RefusesWhatIsNoCurve) {
  EXPECT_THROW(InfraredCurve({}), std::invalid_argument);
  EXPECT_THROW(InfraredCurve({{100, 0.1}}), std::invalid_argument);
  EXPECT_THROW(InfraredCurve({{100, 0.1}, {200, 0.2}}), std::invalid_argument);
  EXPECT_THROW(InfraredCurve({{100, 0.1}, {50, 0.1}}), std::invalid_argument);
  EXPECT_THROW(InfraredCurve({{100, 0.1}, {0, 0.2}}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::sensors

// SPDX-License-Identifier: MIT
#include "host/geometry/parameter_validator.hpp"

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace echomap::geometry {
namespace {

const ParameterValidator kValidator("coastal");

std::string refusal_of(const std::function<void()>& check) {
  try {
    check();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(ParameterValidator, NamesTheFieldItsValueAndItsRange) {
  EXPECT_EQ(refusal_of([] { kValidator.positive("tick_s", -0.5); }),
            "coastal: tick_s = -0.5 is not above 0");
  EXPECT_EQ(refusal_of([] { kValidator.at_least("max_m", 1.5, 2.0); }),
            "coastal: max_m = 1.5 is below 2");
  EXPECT_EQ(refusal_of([] { kValidator.below("share", 1.0, 1.0); }),
            "coastal: share = 1 is not below 1");
  EXPECT_EQ(refusal_of([] { kValidator.at_most("share", 1.5, 1.0); }),
            "coastal: share = 1.5 is above 1");
  EXPECT_EQ(refusal_of([] { kValidator.within("corner_turn_rad", 4.2, 0.0, 3.14); }),
            "coastal: corner_turn_rad = 4.2 is outside 0 .. 3.14");
  EXPECT_EQ(refusal_of([] { kValidator.positive("scans", std::size_t{0}); }),
            "coastal: scans = 0 is not above 0");
}

TEST(ParameterValidator, AcceptsTheEndsOfARangeThatIncludesThem) {
  EXPECT_EQ(refusal_of([] {
              kValidator.at_least("wall_m", 0.0, 0.0)
                  .at_most("share", 1.0, 1.0)
                  .within("share", 0.0, 0.0, 1.0)
                  .within("share", 1.0, 0.0, 1.0)
                  .below("loss", 0.0, 1.0)
                  .above("gain", 1.0, 0.0);
            }),
            "none");
}

TEST(ParameterValidator, RefusesWhatIsNotANumberEverywhere) {
  const double nan = std::nan("");
  EXPECT_NE(refusal_of([&] { kValidator.positive("x", nan); }), "none");
  EXPECT_NE(refusal_of([&] { kValidator.at_least("x", nan, 0.0); }), "none");
  EXPECT_NE(refusal_of([&] { kValidator.below("x", nan, 0.0); }), "none");
  EXPECT_NE(refusal_of([&] { kValidator.at_most("x", nan, 0.0); }), "none");
  EXPECT_NE(refusal_of([&] { kValidator.within("x", nan, 0.0, 1.0); }), "none");
  EXPECT_NE(refusal_of([&] { kValidator.finite("x", nan); }), "none");
}

TEST(ParameterValidator, TellsInfinityFromANumber) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal_of([&] { kValidator.finite("range_m", infinity); }),
            "coastal: range_m = inf is not finite");
  EXPECT_EQ(refusal_of([&] { kValidator.finite("range_m", 1.0); }), "none");
}

TEST(ParameterValidator, SaysARuleThatIsNotAboutOneNumber) {
  EXPECT_EQ(refusal_of([] { kValidator.require(false, "a course needs a waypoint"); }),
            "coastal: a course needs a waypoint");
  EXPECT_EQ(refusal_of([] { kValidator.require(true, "a course needs a waypoint"); }), "none");
}

}  // namespace
}  // namespace echomap::geometry

// SPDX-License-Identifier: MIT
#include "host/models/contact_likelihood.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::models {
namespace {

constexpr WallAhead kTouching{0.0, 0.0, 0.0};
constexpr WallAhead kFarOff{1.0, 0.0, 1.0};

TEST(ContactLikelihood, ABumpSaysThatAWallIsHere) {
  const ContactLikelihood model;
  const ContactReading bump{true, true, true};
  EXPECT_NEAR(model.likelihood(bump, kTouching), 1.0, 1e-6);
  EXPECT_LT(model.likelihood(bump, kFarOff), 0.001);
  EXPECT_GT(model.likelihood(bump, {0.05, 0.0, 0.05}), model.likelihood(bump, {0.1, 0.0, 0.1}));
}

TEST(ContactLikelihood, ABumperFeelsItsOwnSide) {
  const ContactLikelihood model;
  const ContactReading left{true, false, false};
  const WallAhead at_left{0.0, 1.0, 1.0};
  const WallAhead at_right{0.0, -1.0, 1.0};
  EXPECT_GT(model.likelihood(left, at_left), 10.0 * model.likelihood(left, at_right));
  const ContactReading right{false, true, false};
  EXPECT_GT(model.likelihood(right, at_right), 10.0 * model.likelihood(right, at_left));
}

TEST(ContactLikelihood, LightComesBackFromNearWallsOnly) {
  const ContactLikelihood model;
  const ContactReading seen{false, false, true};
  const ContactReading dark{};
  EXPECT_GT(model.likelihood(seen, {0.2, 0.0, 0.2}),
            10.0 * model.likelihood(dark, {0.2, 0.0, 0.2}));
  EXPECT_GT(model.likelihood(dark, kFarOff), 10.0 * model.likelihood(seen, kFarOff));
  const double at_reach = model.likelihood(seen, {0.375, 0.0, 0.375});
  EXPECT_NEAR(at_reach, 0.51, 0.01);
}

TEST(ContactLikelihood, NoTouchSaysThatTheBodyIsNotInAWall) {
  const ContactLikelihood model;
  EXPECT_GT(model.likelihood({}, kFarOff), 0.99);
  EXPECT_LT(model.likelihood({}, {-0.3, 0.0, 1.0}), 0.03);
}

TEST(ContactLikelihood, RefusesParametersWithoutSense) {
  EXPECT_THROW(ContactLikelihood({.contact_stddev_m = 0.0}), std::invalid_argument);
  EXPECT_THROW(ContactLikelihood({.light_reach_m = -0.1}), std::invalid_argument);
  EXPECT_THROW(ContactLikelihood({.wrong_chance = 0.0}), std::invalid_argument);
  EXPECT_THROW(ContactLikelihood({.overlap_rad = -0.1}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::models

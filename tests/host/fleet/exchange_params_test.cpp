// SPDX-License-Identifier: MIT
#include "host/fleet/exchange_params.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/fleet/fleet_of_robots.hpp"

namespace echomap::fleet {
namespace {

TEST(FleetExchangeParams, NeedNamesAndPositiveTimes) {
  const auto is_valid = [](const auto& change) {
    FleetExchangeParams params = FleetOfRobots::params_of("r1");
    change(params);
    try {
      validate(params);
      return true;
    } catch (const std::invalid_argument&) {
      return false;
    }
  };
  using Params = FleetExchangeParams;
  EXPECT_TRUE(is_valid([](Params& /*params*/) {}));
  EXPECT_FALSE(is_valid([](Params& params) { params.fleet = "a/b"; }));
  EXPECT_FALSE(is_valid([](Params& params) { params.robot = ""; }));
  EXPECT_FALSE(is_valid([](Params& params) { params.boot_id = 0; }));
  EXPECT_FALSE(is_valid([](Params& params) { params.traits.body_radius_m = -1.0; }));
  EXPECT_FALSE(is_valid([](Params& params) { params.bytes_per_s = 0.0; }));
  EXPECT_FALSE(is_valid([](Params& params) { params.gone_after_s = params.presence_period_s; }));
}

}  // namespace
}  // namespace echomap::fleet

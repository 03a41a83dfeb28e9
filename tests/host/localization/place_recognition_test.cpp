// SPDX-License-Identifier: MIT
#include "host/localization/place_recognition.hpp"

#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

const RoundScan kCornerScan{0.3, 0.4, 1.0, std::nullopt, 1.2, 0.9, 0.4, 0.3};
const RoundScan kCorridorScan{2.0, 0.5, 0.4, 0.5, 2.0, 0.5, 0.4, 0.5};

RoundScan turned_by(const RoundScan& scan, std::size_t steps) {
  RoundScan turned;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    turned.push_back(scan[(i + steps) % scan.size()]);
  }
  return turned;
}

TEST(PlaceRecognition, KnowsAPlaceHoweverTheRobotStands) {
  const std::vector<RoundScan> places{kCorridorScan, kCornerScan};
  RoundScan scan = turned_by(kCornerScan, 3);
  scan[0] = std::nullopt;
  scan[4] = 0.35;
  const auto place = recognise_place(scan, places);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->place, 1U);
  EXPECT_NEAR(place->turn_rad, 3.0 * std::numbers::pi / 4.0, 1e-12);
  EXPECT_NEAR(place->difference_m, 0.05 / 8.0, 1e-12);
  EXPECT_GT(place->next_difference_m, 0.2);
}

TEST(PlaceRecognition, CountsSilenceAgainstARangeInFull) {
  const RoundScan silent(4);
  const RoundScan loud(4, 9.0);
  const std::vector<RoundScan> places{loud};
  EXPECT_EQ(recognise_place(silent, places, 0.25)->difference_m, 0.25);
  EXPECT_EQ(recognise_place(silent, std::vector<RoundScan>{silent}, 0.25)->difference_m, 0.0);
}

TEST(PlaceRecognition, KnowsNoPlaceAmongNone) { EXPECT_FALSE(recognise_place(kCornerScan, {})); }

TEST(PlaceRecognition, RefusesScansThatDoNotFit) {
  const std::vector<RoundScan> places{kCornerScan};
  EXPECT_THROW(recognise_place(RoundScan(3), places), std::invalid_argument);
  EXPECT_THROW(recognise_place({}, {}), std::invalid_argument);
  EXPECT_THROW(recognise_place(kCornerScan, places, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization

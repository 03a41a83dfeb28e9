// SPDX-License-Identifier: MIT
#include "firmware/drivers/debounced_bits.hpp"

#include <gtest/gtest.h>

#include "protocol/telemetry_messages.hpp"

namespace echomap::drivers {
namespace {

using protocol::kHazardCliffLeft;
using protocol::kHazardWheelDrop;

TEST(DebouncedBits, CountAtTheFirstUpdate) {
  DebouncedBits hazards;
  hazards.update(kHazardCliffLeft);
  EXPECT_EQ(hazards.active(), kHazardCliffLeft);
  EXPECT_EQ(hazards.fresh(), kHazardCliffLeft);
  hazards.update(kHazardCliffLeft | kHazardWheelDrop);
  EXPECT_EQ(hazards.active(), kHazardCliffLeft | kHazardWheelDrop);
  EXPECT_EQ(hazards.fresh(), kHazardWheelDrop);
}

TEST(DebouncedBits, EndWhenTheirLevelsHaveLasted) {
  for (int age_ms = 0; age_ms < DebouncedBits::kReleaseMs; ++age_ms) {
    DebouncedBits hazards;
    for (int ms = 0; ms < age_ms; ++ms) {
      hazards.update(0);
    }
    hazards.update(kHazardCliffLeft);
    int released_ms = 0;
    for (; hazards.active() != 0; ++released_ms) {
      hazards.update(0);
    }
    EXPECT_GE(released_ms, DebouncedBits::kReleaseMs) << age_ms;
    EXPECT_LE(released_ms, DebouncedBits::kMaxReleaseMs) << age_ms;
  }
}

TEST(DebouncedBits, FlickeringIsOneHazard) {
  DebouncedBits hazards;
  int begun = 0;
  for (int i = 0; i < 1000; ++i) {
    hazards.update(i % 15 < 5 ? kHazardCliffLeft : 0);
    begun += hazards.fresh() != 0 ? 1 : 0;
    EXPECT_EQ(hazards.active(), kHazardCliffLeft) << i;
  }
  EXPECT_EQ(begun, 1);
}

TEST(DebouncedBits, OneThatEndsLeavesTheOther) {
  DebouncedBits hazards;
  hazards.update(kHazardCliffLeft | kHazardWheelDrop);
  for (int ms = 0; ms < DebouncedBits::kMaxReleaseMs; ++ms) {
    hazards.update(kHazardWheelDrop);
    EXPECT_EQ(hazards.fresh(), 0);
  }
  EXPECT_EQ(hazards.active(), kHazardWheelDrop);
}

TEST(DebouncedBits, OneThatFlickersHoldsNoOther) {
  DebouncedBits hazards;
  hazards.update(kHazardCliffLeft | kHazardWheelDrop);
  for (int ms = 0; ms < DebouncedBits::kMaxReleaseMs; ++ms) {
    hazards.update(ms % 7 == 0 ? kHazardWheelDrop : 0);
  }
  EXPECT_EQ(hazards.active(), kHazardWheelDrop);
}

TEST(DebouncedBits, MayComeAgain) {
  DebouncedBits hazards;
  hazards.update(kHazardCliffLeft);
  for (int ms = 0; ms < DebouncedBits::kMaxReleaseMs; ++ms) {
    hazards.update(0);
  }
  hazards.update(kHazardCliffLeft);
  EXPECT_EQ(hazards.fresh(), kHazardCliffLeft);
}

}  // namespace
}  // namespace echomap::drivers

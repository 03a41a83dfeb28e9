// SPDX-License-Identifier: MIT
#include "hil_mock/world/wiring.hpp"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::world {
namespace {

TEST(Wiring, EveryNameIsThatOfItsPart) {
  const std::vector<std::string> names = pin_part_names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(pin_part_named(names[i]), static_cast<PinPart>(i)) << names[i];
  }
  EXPECT_EQ(pin_part_named("cliff_front_right"), PinPart::kCliffFrontRight);
  EXPECT_EQ(pin_part_named("wall"), PinPart::kWall);
  EXPECT_EQ(pin_part_named("range_7"), PinPart::kRange7);
  EXPECT_EQ(pin_part_named("stepper_d"), PinPart::kStepperD);
  EXPECT_EQ(pin_part_named("range_8"), std::nullopt);
}

}  // namespace
}  // namespace echomap::world

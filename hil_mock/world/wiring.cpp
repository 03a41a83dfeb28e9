// SPDX-License-Identifier: MIT
#include "hil_mock/world/wiring.hpp"

#include <algorithm>

namespace echomap::world {
namespace {

constexpr std::array<std::string_view, 22> kNames = {
    "cliff_left",   "cliff_front_left", "cliff_front_right",
    "cliff_right",  "wheel_drop",       "virtual_wall",
    "wall",         "scalar_pulses",    "battery",
    "scalar_level", "range_0",          "range_1",
    "range_2",      "range_3",          "range_4",
    "range_5",      "range_6",          "range_7",
    "stepper_a",    "stepper_b",        "stepper_c",
    "stepper_d"};

}  // namespace

std::vector<std::string> pin_part_names() { return {kNames.begin(), kNames.end()}; }

std::optional<PinPart> pin_part_named(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) {
    return std::nullopt;
  }
  return static_cast<PinPart>(found - kNames.begin());
}

}  // namespace echomap::world

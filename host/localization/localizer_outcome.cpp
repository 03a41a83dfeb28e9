// SPDX-License-Identifier: MIT
#include "host/localization/localizer_outcome.hpp"

#include <array>

namespace echomap::localization {

std::string_view text_of(LocalizerOutcome outcome) {
  static constexpr std::array<std::string_view, kLocalizerOutcomes> kTexts{
      "weighed by readings",
      "moved by odometry alone",
      "nothing was heard",
      "no reading has a range and a place that are numbers",
      "nothing is known yet: no readings have come",
      "the robot was thought to be where the map has no floor",
      "a pose is no number",
      "time ran backwards",
      "no cell of the map is known",
      "no cell of the map is free: there is no floor where a robot could be"};
  return kTexts[static_cast<std::size_t>(outcome)];
}

}  // namespace echomap::localization

// SPDX-License-Identifier: MIT
#include "host/localization/localizer_outcome.hpp"

#include <array>

namespace echomap::localization {

std::string_view text_of(LocalizerOutcome outcome) {
  static constexpr std::array<std::string_view, kLocalizerOutcomes> kTexts{
      "updated by readings",
      "moved by odometry alone",
      "no echo",
      "no reading has a finite range and pose",
      "no readings yet",
      "the estimated pose was off the floor of the map",
      "a pose is not finite",
      "time ran backwards",
      "no cell of the map is known",
      "no cell of the map is free: there is no floor where a robot could be"};
  return kTexts[static_cast<std::size_t>(outcome)];
}

}  // namespace echomap::localization

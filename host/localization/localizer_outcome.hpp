// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace echomap::localization {

/// What has become of a localizer's last update or start. Whatever is refused leaves the belief as
/// it is.
enum class LocalizerOutcome : std::uint8_t {
  kWeighed,          ///< The belief was weighed by the readings.
  kMoved,            ///< Nothing came that the model counts: the belief followed the odometry.
  kSilent,           ///< No reading had heard anything: that says little, and to lasers nothing.
  kNoUsableReading,  ///< Readings came, and none has a range and a place that are numbers.
  kNoParticles,      ///< Nothing is known, and nothing that would tell has come.
  kOffTheFloor,      ///< The robot was thought to be where no floor is: it may be anywhere now.
  kNotFinite,        ///< A pose that is no number: refused.
  kTimeRanBack,      ///< A stamp before the last one: refused.
  kUnknownMap,       ///< No cell of the map is known: the robot is nowhere.
  kNoFloor,          ///< No cell of the map is free: the robot is nowhere.
};
inline constexpr std::size_t kLocalizerOutcomes = 10;

/// The same for a user, without a full stop.
std::string_view text_of(LocalizerOutcome outcome);

}  // namespace echomap::localization

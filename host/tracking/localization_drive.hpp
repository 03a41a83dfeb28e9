// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "host/exploration/explorer.hpp"
#include "host/pipeline/robot_atlas.hpp"

namespace echomap::tracking {

/// Of a drive: an atlas whose previous maps nobody will join again.
inline pipeline::RobotAtlasParams only_map() {
  pipeline::RobotAtlasParams params;
  params.keeps_previous_maps = false;
  return params;
}

/// Drives a robot while others, that listen at the same fork, localize it.
class LocalizationDrive {
 public:
  LocalizationDrive() = default;
  LocalizationDrive(const LocalizationDrive&) = delete;
  LocalizationDrive& operator=(const LocalizationDrive&) = delete;
  virtual ~LocalizationDrive() = default;

  /// To the end of the next stop's scan, or of the next stretch of a drive without scans; false
  /// where the session has ended, or the drive is over, which `finished` tells.
  virtual bool go_to_next_stop() = 0;
  /// The robot was carried off: the drive's own map, but for so many of its last stops, is of
  /// somewhere else.
  virtual void begin_new_map(std::size_t stops_elsewhere) = 0;
  virtual std::optional<exploration::FinishReason> finished() const = 0;
  virtual exploration::Intent intent() const = 0;
};

}  // namespace echomap::tracking

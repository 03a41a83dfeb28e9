// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace tasks {

/// The parts of the program without which a robot must not drive.
enum class Part : uint8_t { kTick, kControl, kLink };

/// Kicks the watchdog only when every part has run since the last kick.
class Heartbeat {
 public:
  void ran(Part part);

 private:
  uint8_t ran_ = 0;
};

}  // namespace tasks
}  // namespace echomap

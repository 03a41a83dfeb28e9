// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace boards {

/// Where the host is: "stdio", "tcp:PORT" and "rfcomm:CHANNEL", where the last host to connect is
/// listened to, or "serial:DEVICE", which is opened again when it has gone.
struct Line {
  enum class Kind : uint8_t { kStdio, kTcp, kRfcomm, kSerial };

  Kind kind = Kind::kStdio;
  const char* text = "stdio";    ///< As it was written.
  const char* device = nullptr;  ///< Of kSerial.
  uint16_t number = 0;           ///< The port, 1 .. 65535, or the channel, 1 .. 30.
};

/// What the command line says.
struct Options {
  const char* sysfs = "/sys";   ///< Folder with class/tacho-motor and class/lego-sensor.
  const char* clock = nullptr;  ///< Socket of a simulated clock; none: the kernel's.
  Line line;
};

/// Reads the arguments that the program was started with; wrong ones end it with status 2 and
/// words.
Options read_options();

/// Says what went wrong and ends this process.
[[noreturn]] void fail(const char* what, const char* which);

}  // namespace boards
}  // namespace echomap

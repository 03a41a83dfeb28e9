// SPDX-License-Identifier: MIT
#pragma once

namespace echomap {
namespace boards {

/// What the command line says.
struct Options {
  const char* sysfs = "/sys";    ///< Folder with class/tacho-motor and class/lego-sensor.
  const char* clock = nullptr;   ///< Socket of a simulated clock; none: the kernel's.
  const char* line = "stdio";    ///< See start_line.
};

/// Reads the arguments that the program was started with; wrong ones end it with status 2.
Options read_options();

/// Says what went wrong and ends this process.
[[noreturn]] void fail(const char* what, const char* which);

}  // namespace boards
}  // namespace echomap

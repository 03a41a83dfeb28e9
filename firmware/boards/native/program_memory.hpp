// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "firmware/app/robot.hpp"
#include "firmware/boards/edge_counter/edge_counter.hpp"

namespace echomap {
namespace native {

/// What the portable program's memory holds at an instant between two events. The program has one
/// memory in a process; boards that take turns in it keep theirs here meanwhile.
class ProgramMemory {
 public:
  /// Of the program that is in the memory now.
  static ProgramMemory copy();
  /// Puts it back, to the same addresses.
  void restore() const;

 private:
  std::array<std::byte, sizeof(app::Devices)> devices_;
  std::array<std::byte, sizeof(app::Robot)> robot_;
  boards::EdgeCount edges_;
};

}  // namespace native
}  // namespace echomap

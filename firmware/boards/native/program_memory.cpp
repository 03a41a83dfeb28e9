// SPDX-License-Identifier: MIT
#include "firmware/boards/native/program_memory.hpp"

#include <cstring>
#include <type_traits>

namespace echomap {
namespace native {

static_assert(std::is_trivially_destructible<app::Devices>::value &&
                  std::is_trivially_destructible<app::Robot>::value,
              "the program owns nothing outside of its memory");

ProgramMemory ProgramMemory::copy() {
  ProgramMemory memory;
  std::memcpy(memory.devices_.data(), static_cast<const void*>(&app::devices), sizeof app::devices);
  std::memcpy(memory.robot_.data(), static_cast<const void*>(&app::robot), sizeof app::robot);
  memory.edges_ = boards::edge_count();
  return memory;
}

void ProgramMemory::restore() const {
  std::memcpy(static_cast<void*>(&app::devices), devices_.data(), sizeof app::devices);
  std::memcpy(static_cast<void*>(&app::robot), robot_.data(), sizeof app::robot);
  boards::resume_edge_count(edges_);
}

}  // namespace native
}  // namespace echomap

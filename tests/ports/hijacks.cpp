// SPDX-License-Identifier: MIT
#include "tests/ports/hijacks.hpp"

#include <string>
#include <termios.h>

#include "host/transport/open_stream.hpp"
#include "host/transport/port_lock.hpp"
#include "tests/host/transport/pty_pair.hpp"
#include "tests/support/port_keeper.hpp"

namespace echomap::tests {
namespace {

std::string line_of(const transport::PtyPair& robot) {
  termios settings{};
  ::tcgetattr(robot.fd(), &settings);
  return {reinterpret_cast<const char*>(&settings), sizeof settings};
}

bool is_refused(const std::string& port, int pid) {
  try {
    transport::open_stream(port, 115200);
  } catch (const transport::PortHeldError& error) {
    return error.why().find("process " + std::to_string(pid) + " ") != std::string::npos;
  }
  return false;
}

bool resists(PortKeeping keeping) {
  const transport::PtyPair robot;
  const PortKeeper owner(robot.name(), keeping);
  const std::string line = line_of(robot);
  return is_refused(robot.name(), owner.pid()) && line_of(robot) == line &&
         robot.unread_bytes() == 0;
}

}  // namespace

int measure_refused_hijacks(int tries) {
  int refused = 0;
  for (int i = 0; i < tries; ++i) {
    refused += resists(i % 2 == 0 ? PortKeeping::kFlock : PortKeeping::kTiocexcl) ? 1 : 0;
  }
  return refused;
}

}  // namespace echomap::tests

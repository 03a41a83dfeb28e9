// SPDX-License-Identifier: MIT
#include "host/console/wait_for_enter.hpp"

#include <unistd.h>

#include <sys/poll.h>

#include "host/console/interrupt.hpp"

namespace echomap::console {

bool wait_for_enter() {
  constexpr int kPatienceMs = 50;
  while (!interrupted()) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (::poll(&input, 1, kPatienceMs) <= 0) {
      continue;
    }
    char byte = 0;
    if (::read(STDIN_FILENO, &byte, 1) != 1) {
      return false;
    }
    if (byte == '\n') {
      return true;
    }
  }
  return false;
}

}  // namespace echomap::console

// SPDX-License-Identifier: MIT
#include "host/console/question.hpp"

#include <cstdio>
#include <unistd.h>

#include <fmt/format.h>
#include <sys/poll.h>

#include "host/console/drawn_in_place.hpp"
#include "host/console/interrupt.hpp"

namespace echomap::console {

std::optional<std::string> read_line() {
  constexpr int kPatienceMs = 50;
  std::string line;
  while (!interrupted()) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (::poll(&input, 1, kPatienceMs) <= 0) {
      continue;
    }
    char byte = 0;
    if (::read(STDIN_FILENO, &byte, 1) != 1) {
      return std::nullopt;
    }
    if (byte == '\n') {
      return line;
    }
    line += byte;
  }
  return std::nullopt;
}

std::optional<std::string> ask(const std::string& question) {
  if (::isatty(STDIN_FILENO) == 0 || ::isatty(STDERR_FILENO) == 0) {
    return std::nullopt;
  }
  make_way_for_a_line();
  fmt::print(stderr, "{} ", question);
  return read_line();
}

}  // namespace echomap::console

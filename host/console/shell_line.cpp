// SPDX-License-Identifier: MIT
#include "host/console/shell_line.hpp"

namespace echomap::console {
namespace {

bool is_plain(const std::string& word) {
  static const std::string odd = " \t\n\"'\\$`;&|<>()*?[]#~!{}";
  return !word.empty() && word.find_first_of(odd) == std::string::npos;
}

}  // namespace

std::string shell_line(const CommandWords& command) {
  std::string line;
  for (const std::string& word : command) {
    std::string quoted = word;
    for (std::size_t at = 0; (at = quoted.find('\'', at)) != std::string::npos; at += 4) {
      quoted.replace(at, 1, "'\\''");
    }
    line += (line.empty() ? "" : " ") + (is_plain(word) ? word : "'" + quoted + "'");
  }
  return line;
}

}  // namespace echomap::console

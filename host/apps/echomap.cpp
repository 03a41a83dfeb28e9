// SPDX-License-Identifier: MIT
#include "host/apps/command_line.hpp"

int main(int argc, char** argv) {
  return static_cast<int>(echomap::apps::run_command_line(argc, argv));
}

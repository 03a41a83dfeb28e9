// SPDX-License-Identifier: MIT
#include "firmware/boards/ev3/options.hpp"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "protocol/version.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr const char* kUsage =
    "usage: echomap-ev3 [--line stdio|tcp:PORT|rfcomm:CHANNEL|serial:DEVICE]\n"
    "                   [--sysfs FOLDER] [--clock unix:SOCKET] [--version]\n";
constexpr int kWrongUse = 2;

int argument_count = 0;
char** arguments = nullptr;

/// The C library hands these to every initializer as it does to main, which the boards share.
__attribute__((constructor)) void keep_arguments(int count, char** values) {
  argument_count = count;
  arguments = values;
}

[[noreturn]] void explain() {
  fputs(kUsage, stderr);
  _exit(kWrongUse);
}

const char* after(const char* text, const char* start) {
  const size_t length = strlen(start);
  if (strncmp(text, start, length) != 0) {
    explain();
  }
  return text + length;
}

[[noreturn]] void tell_version() {
  printf("echomap-ev3 %s\n", protocol::VersionText(protocol::kFirmwareVersion).text());
  exit(0);
}

}  // namespace

Options read_options() {
  Options options;
  for (int i = 1; i < argument_count; i += 2) {
    const char* const name = arguments[i];
    if (strcmp(name, "--version") == 0) {
      tell_version();
    }
    if (i + 1 == argument_count) {
      explain();
    }
    const char* const value = arguments[i + 1];
    if (strcmp(name, "--sysfs") == 0) {
      options.sysfs = value;
    } else if (strcmp(name, "--clock") == 0) {
      options.clock = after(value, "unix:");
    } else if (strcmp(name, "--line") == 0) {
      options.line = value;
    } else {
      explain();
    }
  }
  return options;
}

void fail(const char* what, const char* which) {
  fprintf(stderr, "echomap-ev3: %s: %s: %s\n", which, what, strerror(errno));
  _exit(1);
}

}  // namespace boards
}  // namespace echomap

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

[[noreturn]] void refuse(const char* option, const char* value, const char* fault) {
  fprintf(stderr, "echomap-ev3: %s %s: %s\n%s", option, value, fault, kUsage);
  _exit(kWrongUse);
}

/// What follows `start`; null in a text that starts otherwise.
const char* after(const char* text, const char* start) {
  const size_t length = strlen(start);
  return strncmp(text, start, length) == 0 ? text + length : nullptr;
}

/// A number in digits alone; 0 of all else, and of one beyond `max`.
uint16_t number_of(const char* digits, uint32_t max) {
  uint32_t number = 0;
  for (; *digits != '\0'; ++digits) {
    if (*digits < '0' || *digits > '9') {
      return 0;
    }
    number = number * 10 + static_cast<uint32_t>(*digits - '0');
    if (number > max) {
      return 0;
    }
  }
  return static_cast<uint16_t>(number);
}

Line line_of(const char* text) {
  constexpr uint32_t kMaxPort = 65535;
  constexpr uint32_t kMaxChannel = 30;
  Line line;
  line.text = text;
  if (const char* const port = after(text, "tcp:")) {
    line.kind = Line::Kind::kTcp;
    line.number = number_of(port, kMaxPort);
    if (line.number == 0) {
      refuse("--line", text, "a TCP port is a number of 1 .. 65535");
    }
  } else if (const char* const channel = after(text, "rfcomm:")) {
    line.kind = Line::Kind::kRfcomm;
    line.number = number_of(channel, kMaxChannel);
    if (line.number == 0) {
      refuse("--line", text, "a channel of Bluetooth is a number of 1 .. 30");
    }
  } else if (const char* const device = after(text, "serial:")) {
    line.kind = Line::Kind::kSerial;
    line.device = device;
    if (*device == '\0') {
      refuse("--line", text, "the device is missing, such as /dev/ttyGS0");
    }
  } else if (strcmp(text, "stdio") != 0) {
    refuse("--line", text, "there is no such line");
  }
  return line;
}

const char* clock_of(const char* text) {
  const char* const path = after(text, "unix:");
  if (path == nullptr) {
    refuse("--clock", text, "a simulated clock is unix:SOCKET");
  }
  return path;
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
      refuse(name, "", "there is no such option, or its value is missing");
    }
    const char* const value = arguments[i + 1];
    if (strcmp(name, "--sysfs") == 0) {
      options.sysfs = value;
    } else if (strcmp(name, "--clock") == 0) {
      options.clock = clock_of(value);
    } else if (strcmp(name, "--line") == 0) {
      options.line = line_of(value);
    } else {
      refuse(name, value, "there is no such option");
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

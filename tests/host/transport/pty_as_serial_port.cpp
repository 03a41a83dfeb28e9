// SPDX-License-Identifier: MIT
/// Makes a pty pass for a serial device in the program that links this file, so that libserialport
/// and serial_port.cpp run in full where no device is plugged in. The program's definitions of
/// these functions come before the C library's; they answer the questions to which a pty has no
/// answer (its place in /sys, its modem lines) and hand all others to the kernel.

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <unistd.h>

#include <linux/serial.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include "tests/host/transport/modem_lines.hpp"

namespace echomap::transport {

ModemLines& modem_lines() {
  static ModemLines lines;
  return lines;
}

}  // namespace echomap::transport

namespace {

using echomap::transport::modem_lines;
using echomap::transport::ModemLines;

bool is_place_of_pty(const char* path) {
  return std::string_view(path).substr(0, 19) == "/sys/class/tty/pts/";
}

void set_lines(int lines) {
  ModemLines& modem = modem_lines();
  const bool falls = (modem.up & TIOCM_DTR) != 0 && (lines & TIOCM_DTR) == 0;
  modem.falls_of_dtr += falls ? 1 : 0;
  modem.up = lines;
}

/// -1 where `request` is about something else, or fails as it was told to.
int answer_modem_lines(unsigned long request, int* argument) {
  ModemLines& modem = modem_lines();
  if (modem.requests_until_failure == 0) {
    errno = EIO;
    return -1;
  }
  modem.requests_until_failure -= modem.requests_until_failure > 0 ? 1 : 0;
  switch (request) {
    case TIOCMGET:
      *argument = modem.up;
      return 0;
    case TIOCMSET:
      set_lines(*argument);
      return 0;
    case TIOCMBIS:
      set_lines(modem.up | *argument);
      return 0;
    case TIOCMBIC:
      set_lines(modem.up & ~*argument);
      return 0;
    default:
      errno = ENOTTY;
      return -1;
  }
}

int answer_driver_flags(unsigned long request, serial_struct& settings) {
  int& flags = modem_lines().driver_flags;
  if (flags < 0) {
    errno = ENOTTY;
    return -1;
  }
  if (request == TIOCGSERIAL) {
    settings.flags = flags;
  } else {
    flags = settings.flags;
  }
  return 0;
}

}  // namespace

extern "C" {

int ioctl(int fd, unsigned long request, ...) noexcept {
  va_list arguments;
  va_start(arguments, request);
  void* argument = va_arg(arguments, void*);
  va_end(arguments);
  const auto result = static_cast<int>(::syscall(SYS_ioctl, fd, request, argument));
  if (result == -1 && (request == TIOCGSERIAL || request == TIOCSSERIAL)) {
    return answer_driver_flags(request, *static_cast<serial_struct*>(argument));
  }
  if (result == -1 && errno == ENOTTY) {
    return answer_modem_lines(request, static_cast<int*>(argument));
  }
  return result;
}

int lxstat_of_pty(int version, const char* path, struct stat* into) __asm__("__lxstat");
int lxstat_of_pty(int /*version*/, const char* path, struct stat* into) {
  if (is_place_of_pty(path)) {
    *into = {};
    into->st_mode = S_IFLNK;
    return 0;
  }
  return ::fstatat(AT_FDCWD, path, into, AT_SYMLINK_NOFOLLOW);
}

ssize_t readlink(const char* path, char* buf, size_t len) noexcept {
  constexpr std::string_view kTarget = "../../devices/virtual/tty/pts";
  if (is_place_of_pty(path)) {
    const size_t count = std::min(len, kTarget.size());
    std::memcpy(buf, kTarget.data(), count);
    return static_cast<ssize_t>(count);
  }
  return ::readlinkat(AT_FDCWD, path, buf, len);
}
}

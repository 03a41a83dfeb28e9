// SPDX-License-Identifier: MIT
#include "host/transport/low_latency.hpp"

#include <linux/serial.h>
#include <sys/ioctl.h>

namespace echomap::transport {
namespace {

/// False where nothing has changed.
bool switch_low_latency(int fd, bool on) {
  serial_struct settings{};
  if (::ioctl(fd, TIOCGSERIAL, &settings) != 0 ||
      ((settings.flags & ASYNC_LOW_LATENCY) != 0) == on) {
    return false;
  }
  settings.flags ^= ASYNC_LOW_LATENCY;
  return ::ioctl(fd, TIOCSSERIAL, &settings) == 0;
}

}  // namespace

bool lower_latency(int fd) { return switch_low_latency(fd, true); }

void restore_latency(int fd) { switch_low_latency(fd, false); }

}  // namespace echomap::transport

// SPDX-License-Identifier: MIT
#include "firmware/boards/ev3/clock.hpp"

#include <errno.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <sys/socket.h>
#include <sys/un.h>

#include "firmware/boards/ev3/options.hpp"
#include "firmware/boards/ev3/parts.hpp"
#include "firmware/hal/clock.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr size_t kTimeBytes = 8;
constexpr uint64_t kUsPerS = 1000000;
constexpr long kNsPerUs = 1000;

int clock_socket = -1;
uint64_t start_us = 0;
uint64_t told_us = 0;

uint64_t kernel_us() {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<uint64_t>(now.tv_sec) * kUsPerS + static_cast<uint64_t>(now.tv_nsec / kNsPerUs);
}

/// False when a signal came first. A world that has gone leaves nothing to do.
bool hear_time() {
  uint8_t bytes[kTimeBytes];
  const ssize_t count = recv(clock_socket, bytes, sizeof bytes, MSG_WAITALL);
  if (count < 0 && errno == EINTR) {
    return false;
  }
  if (count != static_cast<ssize_t>(sizeof bytes)) {
    stop_all_motors();
    _exit(0);
  }
  told_us = 0;
  for (size_t i = kTimeBytes; i-- > 0;) {
    told_us = told_us << 8 | bytes[i];
  }
  return true;
}

void ask_for_time(uint64_t until_us) {
  uint8_t bytes[kTimeBytes];
  for (uint8_t& byte : bytes) {
    byte = static_cast<uint8_t>(until_us);
    until_us >>= 8;
  }
  send(clock_socket, bytes, sizeof bytes, MSG_NOSIGNAL);
}

void connect_clock(const char* path) {
  if (clock_socket >= 0) {
    close(clock_socket);
  }
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  strncpy(address.sun_path, path, sizeof address.sun_path - 1);
  clock_socket = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the interface of the kernel
  const sockaddr* const generic = reinterpret_cast<const sockaddr*>(&address);
  if (clock_socket < 0 || connect(clock_socket, generic, sizeof address) != 0) {
    fail("no clock", path);
  }
}

}  // namespace

void start_clock(const char* socket) {
  if (socket == nullptr) {
    start_us = kernel_us();
    return;
  }
  connect_clock(socket);
  while (!hear_time()) {
  }
  start_us = told_us;
}

bool is_simulated() { return clock_socket >= 0; }

uint64_t clock_us() { return (is_simulated() ? told_us : kernel_us()) - start_us; }

uint64_t started_at_us() { return is_simulated() ? start_us : 0; }

void sleep_until(uint64_t until_us, pollfd* waits, nfds_t count) {
  if (is_simulated()) {
    ask_for_time(start_us + until_us);
    hear_time();
    return;
  }
  const uint64_t now_us = clock_us();
  const uint64_t left_us = until_us > now_us ? until_us - now_us : 0;
  timespec left;
  left.tv_sec = static_cast<time_t>(left_us / kUsPerS);
  left.tv_nsec = static_cast<long>(left_us % kUsPerS) * kNsPerUs;
  ppoll(waits, count, &left, nullptr);
}

}  // namespace boards

namespace hal {

uint32_t now_us() { return static_cast<uint32_t>(boards::clock_us()); }

}  // namespace hal
}  // namespace echomap

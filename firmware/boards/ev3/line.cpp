// SPDX-License-Identifier: MIT
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include "firmware/boards/ev3/clock.hpp"
#include "firmware/boards/ev3/options.hpp"
#include "firmware/boards/ev3/parts.hpp"
#include "firmware/hal/events.hpp"
#include "firmware/hal/uart.hpp"

namespace echomap {
namespace boards {
namespace {

/// At once: fewer than the program's buffer takes before it looks.
constexpr size_t kReceiveBytes = 32;
constexpr size_t kSendBytes = 512;
constexpr uint64_t kOpenAgainUs = 500000;
/// Bluetooth's serial line carries about as much as a wire of 115200 baud.
constexpr uint16_t kRfcommBytesPerS = 11520;

/// Without Bluetooth's headers, which come with its library.
constexpr int kBluetoothFamily = 31;
constexpr int kRfcommProtocol = 3;
struct RfcommAddress {
  sa_family_t family;
  uint8_t device[6];
  uint8_t channel;
};

Line host_line;
int listener = -1;
uint64_t opened_us = 0;
bool waits_for_device = false;
int input = -1;
int output = -1;
uint16_t bytes_per_s = UINT16_MAX;
bool wants_to_send = false;
uint8_t unsent[kSendBytes];
size_t unsent_bytes = 0;

void set_non_blocking(int file) { fcntl(file, F_SETFL, fcntl(file, F_GETFL) | O_NONBLOCK); }

void listen_at(int family, int protocol, const void* address, socklen_t size) {
  const int on = 1;
  listener = socket(family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, protocol);
  if (listener < 0 || setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) != 0 ||
      bind(listener, static_cast<const sockaddr*>(address), size) != 0 ||
      listen(listener, 1) != 0) {
    fail("cannot listen", host_line.text);
  }
}

void listen_on_port() {
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(host_line.number);
  address.sin_addr.s_addr = htonl(INADDR_ANY);
  listen_at(AF_INET, 0, &address, sizeof address);
}

void listen_on_channel() {
  RfcommAddress address = {};
  address.family = kBluetoothFamily;
  address.channel = static_cast<uint8_t>(host_line.number);
  bytes_per_s = kRfcommBytesPerS;
  listen_at(kBluetoothFamily, kRfcommProtocol, &address, sizeof address);
}

/// A gadget's device comes and goes with its cable.
void open_device() {
  opened_us = clock_us();
  input = open(host_line.device, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  output = input;
  termios settings;
  if (input >= 0 && tcgetattr(input, &settings) == 0) {
    cfmakeraw(&settings);
    tcsetattr(input, TCSANOW, &settings);
  }
  if (input < 0 && !waits_for_device) {
    fprintf(stderr,
            "echomap-ev3: %s: cannot be opened yet, it is tried again: %s\n",
            host_line.device,
            strerror(errno));
  }
  waits_for_device = input < 0;
}

/// What was meant for one host is not for the next.
void drop_host() {
  if (input >= 0) {
    close(input);
  }
  input = -1;
  output = -1;
  unsent_bytes = 0;
}

/// A host that comes back may have gone without a word: the last one is it.
void take_host() {
  const int host =
      listener < 0 ? -1 : accept4(listener, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (host >= 0) {
    // Else a frame waits until the one before is acknowledged. Bluetooth's lines have no such
    // option.
    const int on = 1;
    setsockopt(host, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    drop_host();
    input = host;
    output = host;
  }
  if (host_line.kind == Line::Kind::kSerial && input < 0 &&
      clock_us() - opened_us >= kOpenAgainUs) {
    open_device();
  }
}

/// Who started the program on its standard input and has gone needs no robot any more.
void lose_host() {
  if (host_line.kind == Line::Kind::kStdio) {
    stop_all_motors();
    _exit(0);
  }
  drop_host();
}

void fill_unsent() {
  while (wants_to_send && unsent_bytes < kSendBytes) {
    wants_to_send = hal::next_byte_to_send(unsent[unsent_bytes]);
    unsent_bytes += wants_to_send ? 1U : 0U;
  }
}

}  // namespace

void start_line(const Line& line) {
  host_line = line;
  switch (host_line.kind) {
    case Line::Kind::kStdio:
      input = STDIN_FILENO;
      output = STDOUT_FILENO;
      set_non_blocking(input);
      set_non_blocking(output);
      break;
    case Line::Kind::kTcp:
      listen_on_port();
      break;
    case Line::Kind::kRfcomm:
      listen_on_channel();
      break;
    case Line::Kind::kSerial:
      open_device();
      break;
  }
}

void send_to_line() {
  for (fill_unsent(); unsent_bytes != 0; fill_unsent()) {
    const ssize_t count =
        output < 0 ? static_cast<ssize_t>(unsent_bytes) : write(output, unsent, unsent_bytes);
    if (count <= 0) {
      if (count < 0 && errno != EAGAIN && errno != EINTR) {
        lose_host();
      }
      return;
    }
    unsent_bytes -= static_cast<size_t>(count);
    memmove(unsent, unsent + count, unsent_bytes);
  }
}

bool receive_from_line() {
  take_host();
  uint8_t bytes[kReceiveBytes];
  const ssize_t count = input < 0 ? -1 : read(input, bytes, sizeof bytes);
  const bool is_empty = input < 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
  if (!is_empty && count <= 0) {
    lose_host();
  }
  for (ssize_t i = 0; i < count; ++i) {
    hal::on_byte_received(bytes[i]);
  }
  return count > 0;
}

nfds_t waits_of_line(pollfd (&waits)[kMaxWaits]) {
  nfds_t count = 0;
  if (listener >= 0) {
    waits[count++] = pollfd{listener, POLLIN, 0};
  }
  if (input >= 0) {
    waits[count++] = pollfd{input, POLLIN, 0};
  }
  return count;
}

}  // namespace boards

namespace hal {

void request_send() { boards::wants_to_send = true; }

uint16_t line_bytes_per_s() { return boards::bytes_per_s; }

}  // namespace hal
}  // namespace echomap

// SPDX-License-Identifier: MIT
#include "host/transport/pty_port.hpp"

#include <cerrno>
#include <system_error>
#include <termios.h>

#include "host/transport/descriptor_stream.hpp"
#include "host/transport/file_descriptor.hpp"
#include "host/transport/port_lock.hpp"
#include "host/transport/transport_error.hpp"

namespace echomap::transport {
namespace {

[[noreturn]] void fail(const std::string& path) {
  throw TransportError("cannot open the pty " + path,
                       std::generic_category().message(errno),
                       "start the emulated robot again, or leave --port out to use `echomap demo`");
}

void make_raw(int fd, const std::string& path) {
  termios settings{};
  if (tcgetattr(fd, &settings) != 0) {
    fail(path);
  }
  cfmakeraw(&settings);
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
  if (tcsetattr(fd, TCSANOW, &settings) != 0 || tcflush(fd, TCIOFLUSH) != 0) {
    fail(path);
  }
}

}  // namespace

std::unique_ptr<ByteStream> open_pty_port(const std::string& path) {
  FileDescriptor fd(open_port_alone(path));
  if (fd.get() < 0) {
    fail(path);
  }
  make_raw(fd.get(), path);
  return descriptor_stream(fd.release(), path);
}

}  // namespace echomap::transport

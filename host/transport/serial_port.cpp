// SPDX-License-Identifier: MIT
#include "host/transport/serial_port.hpp"

#include <cerrno>
#include <cstdlib>
#include <libserialport.h>
#include <system_error>
#include <termios.h>

#include "host/transport/descriptor_stream.hpp"
#include "host/transport/file_descriptor.hpp"
#include "host/transport/low_latency.hpp"
#include "host/transport/port_list.hpp"
#include "host/transport/port_lock.hpp"
#include "host/transport/transport_error.hpp"

namespace echomap::transport {
namespace {

struct ClosePort {
  void operator()(sp_port* port) const {
    sp_close(port);
    sp_free_port(port);
  }
};
using Port = std::unique_ptr<sp_port, ClosePort>;

std::string next_step(int error_number) {
  switch (error_number) {
    case EACCES:
    case EPERM:
      return "sudo usermod -aG dialout $USER, then log in again";
    default: {
      const auto ports = list_ports();
      return ports.empty() ? "plug the robot in, or try without one: echomap demo"
                           : "echomap explore --port " + ports.front().name;
    }
  }
}

[[noreturn]] void fail(const std::string& path, int error_number) {
  const bool is_missing = error_number == ENOENT || error_number == ENODEV;
  std::string why = std::generic_category().message(error_number);
  if (is_missing) {
    why += "; " + describe_ports(list_ports());
  }
  throw TransportError("cannot open the serial port " + path, why, next_step(error_number));
}

/// The device behind links like /dev/serial/by-id/..: libserialport takes no link.
std::string resolved(const std::string& path) {
  const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr),
                                                         std::free);
  if (real == nullptr) {
    fail(path, errno);
  }
  return real.get();
}

void check(sp_return result, const std::string& path, int fallback_error) {
  if (result != SP_OK) {
    fail(path, result == SP_ERR_FAIL ? sp_last_error_code() : fallback_error);
  }
}

/// The device, open without a change to its modem lines. libserialport sets HUPCL, with which the
/// kernel drops DTR at the last closing, and the next opening resets the board by raising it. As
/// long as this is open no other closing is the last one; its own is without HUPCL.
class SteadyDevice {
 public:
  explicit SteadyDevice(const std::string& path) : fd_(open_port_alone(path)) {
    if (fd_.get() < 0) {
      fail(path, errno);
    }
  }
  ~SteadyDevice() { correct_settings(); }
  SteadyDevice(const SteadyDevice&) = delete;
  SteadyDevice& operator=(const SteadyDevice&) = delete;

  int get() const { return fd_.get(); }
  int release() { return fd_.release(); }

  /// HUPCL off, and VMIN at 1: Asio takes a read at VMIN 0 for the end of the stream.
  bool correct_settings() {
    termios settings{};
    if (fd_.get() < 0 || tcgetattr(fd_.get(), &settings) != 0) {
      return false;
    }
    settings.c_cc[VMIN] = 1;
    settings.c_cc[VTIME] = 0;
    settings.c_cflag &= ~static_cast<tcflag_t>(HUPCL);
    return tcsetattr(fd_.get(), TCSANOW, &settings) == 0;
  }

 private:
  FileDescriptor fd_;
};

Port open_port(const std::string& path) {
  sp_port* found = nullptr;
  check(sp_get_port_by_name(resolved(path).c_str(), &found), path, ENOTTY);
  Port port(found);
  check(sp_open(port.get(), SP_MODE_READ_WRITE), path, ENOTTY);
  return port;
}

void configure(sp_port* port, const std::string& path, int baud) {
  check(sp_set_baudrate(port, baud), path, EINVAL);
  check(sp_set_bits(port, 8), path, EINVAL);
  check(sp_set_parity(port, SP_PARITY_NONE), path, EINVAL);
  check(sp_set_stopbits(port, 1), path, EINVAL);
  check(sp_set_flowcontrol(port, SP_FLOWCONTROL_NONE), path, EINVAL);
  check(sp_flush(port, SP_BUF_BOTH), path, EINVAL);
}

}  // namespace

std::unique_ptr<ByteStream> open_serial_port(const std::string& path, int baud) {
  if (baud <= 0) {
    throw TransportError("cannot open the serial port " + path,
                         std::to_string(baud) + " is no baud rate",
                         "leave --baud out, or name what the firmware was built for");
  }
  SteadyDevice device(path);
  const Port port = open_port(path);
  configure(port.get(), path, baud);
  if (!device.correct_settings()) {
    fail(path, errno);
  }
  // Not before libserialport, whose own opening it would keep out.
  exclude_others(device.get());
  const bool is_faster = lower_latency(device.get());
  return serial_stream(device.release(), path, [is_faster](int fd) {
    admit_others(fd);
    if (is_faster) {
      restore_latency(fd);
    }
  });
}

}  // namespace echomap::transport

// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <string>
#include <unistd.h>

#include <sys/socket.h>
#include <sys/un.h>

#include "hil_mock/runner/descriptor.hpp"

namespace echomap::runner {

/// A blocking end of a stream, as a host has it; reads give up after five seconds.
class TestHost {
 public:
  explicit TestHost(Descriptor descriptor) : descriptor_(std::move(descriptor)) {}

  static TestHost open_terminal(const std::filesystem::path& path) {
    return TestHost({::open(path.c_str(), O_RDWR | O_NOCTTY), path.string()});
  }

  static TestHost connect_local(const std::filesystem::path& path) {
    Descriptor socket(::socket(AF_UNIX, SOCK_STREAM, 0), "socket");
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    check_call(
        ::connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address),
        path.string());
    return TestHost(std::move(socket));
  }

  void write(const std::string& bytes) {
    ASSERT_EQ(::write(descriptor_.number(), bytes.data(), bytes.size()),
              static_cast<ssize_t>(bytes.size()));
  }

  /// `count` bytes, or fewer where the other end closes or stays silent.
  std::string read(std::size_t count) {
    std::string bytes;
    pollfd readable{descriptor_.number(), POLLIN, 0};
    while (bytes.size() < count && ::poll(&readable, 1, 5000) > 0) {
      char byte = 0;
      if (::read(descriptor_.number(), &byte, 1) != 1) {
        break;
      }
      bytes.push_back(byte);
    }
    return bytes;
  }

  /// Up to and without the line end.
  std::string read_line() {
    std::string line;
    for (std::string byte = read(1); byte.size() == 1 && byte != "\n"; byte = read(1)) {
      line += byte;
    }
    return line;
  }

  void close() { descriptor_.close(); }

 private:
  Descriptor descriptor_;
};

/// Every byte value once.
inline std::string all_bytes() {
  std::string bytes;
  for (int value = 0; value < 256; ++value) {
    bytes.push_back(static_cast<char>(value));
  }
  return bytes;
}

}  // namespace echomap::runner

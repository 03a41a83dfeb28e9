// SPDX-License-Identifier: MIT
#include "tests/host/transport/pty_pair.hpp"

#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <numeric>
#include <poll.h>
#include <stdexcept>
#include <termios.h>
#include <unistd.h>

#include <sys/ioctl.h>

namespace echomap::transport {
namespace {

constexpr std::chrono::seconds kPatience{5};

}  // namespace

PtyPair::PtyPair()
    : master_(std::make_unique<FileDescriptor>(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC))) {
  std::array<char, 64> name{};
  if (::grantpt(fd()) != 0 || ::unlockpt(fd()) != 0 ||
      ::ptsname_r(fd(), name.data(), name.size()) != 0) {
    throw std::runtime_error("no pseudo terminal to test with");
  }
  name_ = name.data();
  slave_ = std::make_unique<FileDescriptor>(::open(name_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  termios settings{};
  ::tcgetattr(slave_->get(), &settings);
  ::cfmakeraw(&settings);
  ::tcsetattr(slave_->get(), TCSANOW, &settings);
}

void PtyPair::write(std::span<const std::uint8_t> bytes) {
  if (::write(fd(), bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("the pseudo terminal took less than all bytes");
  }
}

std::vector<std::uint8_t> PtyPair::read(std::size_t count) {
  std::vector<std::uint8_t> bytes;
  pollfd readable{fd(), POLLIN, 0};
  while (bytes.size() < count && ::poll(&readable, 1, 5000) > 0) {
    std::array<std::uint8_t, 4096> piece{};
    const ssize_t got = ::read(fd(), piece.data(), piece.size());
    if (got <= 0) {
      break;
    }
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + got);
  }
  return bytes;
}

std::size_t PtyPair::unread_bytes() const {
  constexpr int kDeliveryMs = 20;  // The kernel hands bytes on by a thread of its own.
  pollfd readable{fd(), POLLIN, 0};
  int count = 0;
  return ::poll(&readable, 1, kDeliveryMs) > 0 && ::ioctl(fd(), FIONREAD, &count) == 0
             ? static_cast<std::size_t>(count)
             : 0;
}

void PtyPair::unplug() {
  slave_.reset();
  master_.reset();
}

std::vector<std::uint8_t> read_bytes(ByteStream& stream, std::size_t count) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  std::vector<std::uint8_t> bytes;
  std::array<std::uint8_t, 256> piece{};
  while (bytes.size() < count && std::chrono::steady_clock::now() < deadline) {
    const std::size_t got = stream.read_some(piece, std::chrono::milliseconds(50));
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(got));
    if (got == 0 && stream.status() == StreamStatus::kClosed) {
      break;
    }
  }
  return bytes;
}

std::vector<std::uint8_t> counting_bytes(std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  return bytes;
}

}  // namespace echomap::transport

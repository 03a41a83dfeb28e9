// SPDX-License-Identifier: MIT
#include "hil_mock/runner/pty_endpoint.hpp"

#include <array>
#include <fcntl.h>
#include <stdexcept>
#include <stdlib.h>
#include <system_error>
#include <termios.h>
#include <unistd.h>
#include <utility>

namespace echomap::runner {
namespace {

namespace fs = std::filesystem;

std::string slave_name(int master) {
  std::array<char, 128> name{};
  check_call(-::ptsname_r(master, name.data(), name.size()), "ptsname");
  return name.data();
}

void make_raw(int terminal) {
  termios settings{};
  check_call(::tcgetattr(terminal, &settings), "tcgetattr");
  ::cfmakeraw(&settings);
  check_call(::tcsetattr(terminal, TCSANOW, &settings), "tcsetattr");
}

}  // namespace

PtyEndpoint::PtyEndpoint(fs::path link, WhenUnread when_unread)
    : link_(std::move(link)),
      outgoing_(when_unread),
      master_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC), "cannot open a pty") {
  check_call(::grantpt(master_.number()), "grantpt");
  check_call(::unlockpt(master_.number()), "unlockpt");
  set_non_blocking(master_.number());
  slave_path_ = slave_name(master_.number());
  slave_ = Descriptor(::open(slave_path_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC), slave_path_);
  make_raw(slave_.number());
  publish_link();
}

PtyEndpoint::~PtyEndpoint() {
  std::error_code ignored;
  if (fs::read_symlink(link_, ignored) == slave_path_) {
    fs::remove(link_, ignored);
  }
}

std::vector<std::uint8_t> PtyEndpoint::receive() {
  std::vector<std::uint8_t> bytes;
  std::array<std::uint8_t, 4096> chunk{};
  ssize_t count = 0;
  while ((count = ::read(master_.number(), chunk.data(), chunk.size())) > 0) {
    bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + count);
  }
  return bytes;
}

void PtyEndpoint::send(std::span<const std::uint8_t> bytes) {
  outgoing_.push(bytes);
  outgoing_.write_to(master_.number());
}

void PtyEndpoint::publish_link() const {
  std::error_code ignored;
  const fs::file_status there = fs::symlink_status(link_, ignored);
  if (fs::exists(there) && !fs::is_symlink(there)) {
    throw std::runtime_error(link_.string() +
                             " exists and is no symbolic link; choose --link PATH");
  }
  fs::path temporary = link_;
  temporary += "." + std::to_string(::getpid());
  fs::create_symlink(slave_path_, temporary);
  fs::rename(temporary, link_);
}

}  // namespace echomap::runner

// SPDX-License-Identifier: MIT
#include "hil_mock/runner/lockstep_server.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <sys/socket.h>
#include <sys/un.h>

namespace echomap::runner {
namespace {

/// Takes one number and the blank before it from the front of `text`.
template <class Number>
bool take_number(std::string_view& text, Number& number) {
  if (text.empty() || text.front() != ' ') {
    return false;
  }
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc{};
}

sockaddr_un local_address(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = path.string();
  if (name.size() >= sizeof address.sun_path) {
    throw std::runtime_error(name + ": too long for the name of a socket (107 characters)");
  }
  std::memcpy(address.sun_path, name.data(), name.size());
  return address;
}

}  // namespace

/// Simulated time is counted in nanoseconds.
constexpr std::int64_t kLastMicrosecond = std::numeric_limits<std::int64_t>::max() / 1000;
/// Nobody holds a robot for longer than an hour.
constexpr std::int64_t kLongestHoldUs = 3'600'000'000;

LockstepRequest parse_request(std::string_view line) {
  constexpr std::string_view kGrant = "grant";
  constexpr std::string_view kCarryOff = "carry-off";
  if (line == "quit") {
    return Quit{};
  }
  std::string_view rest = line;
  if (rest.starts_with(kCarryOff)) {
    rest.remove_prefix(kCarryOff.size());
    CarryOff carry;
    if (take_number(rest, carry.held_us) && rest.empty() && carry.held_us > 0 &&
        carry.held_us <= kLongestHoldUs) {
      return carry;
    }
  }
  Grant grant;
  if (rest.starts_with(kGrant)) {
    rest.remove_prefix(kGrant.size());
    if (take_number(rest, grant.until_us) && take_number(rest, grant.host_bytes) && rest.empty() &&
        grant.until_us <= kLastMicrosecond) {
      return grant;
    }
  }
  return BadRequest{std::string(line)};
}

LockstepServer::LockstepServer(std::filesystem::path socket, std::string hello)
    : socket_(std::move(socket)),
      hello_(std::move(hello)),
      listener_(::socket(AF_UNIX, SOCK_STREAM | kSocketFlags, 0), "socket") {
  std::filesystem::path temporary = socket_;
  temporary += "." + std::to_string(::getpid());
  const sockaddr_un address = local_address(temporary);
  const std::string tried = "cannot listen on " + socket_.string();
  std::error_code ignored;
  const auto there = std::filesystem::symlink_status(socket_, ignored);
  if (std::filesystem::exists(there) && !std::filesystem::is_socket(there)) {
    throw std::runtime_error(tried + ": a file that is no socket is there; choose another path");
  }
  check_call(
      ::bind(listener_.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address),
      tried);
  check_call(::listen(listener_.number(), 1), tried);
  std::filesystem::rename(temporary, socket_);
}

LockstepServer::~LockstepServer() {
  std::error_code ignored;
  std::filesystem::remove(socket_, ignored);
}

std::optional<LockstepRequest> LockstepServer::take_request() {
  if (!host_.is_open()) {
    accept_host();
    return std::nullopt;
  }
  std::array<char, 512> chunk{};
  ssize_t count = 0;
  while ((count = ::read(host_.number(), chunk.data(), chunk.size())) > 0) {
    received_.append(chunk.data(), static_cast<std::size_t>(count));
  }
  ended_ = ended_ || count == 0 || (errno != EAGAIN && errno != EINTR);
  const std::size_t line_end = received_.find('\n');
  if (line_end != std::string::npos) {
    const LockstepRequest request = parse_request({received_.data(), line_end});
    received_.erase(0, line_end + 1);
    return request;
  }
  if (ended_) {
    return HostGone{};
  }
  return std::nullopt;
}

void LockstepServer::send_reached(std::int64_t until_us, std::uint64_t device_bytes) {
  send_line("reached " + std::to_string(until_us) + " " + std::to_string(device_bytes));
}

void LockstepServer::send_bye() { send_line("bye"); }

int LockstepServer::descriptor() const {
  return host_.is_open() ? host_.number() : listener_.number();
}

void LockstepServer::accept_host() {
  const int accepted = ::accept4(listener_.number(), nullptr, nullptr, kSocketFlags);
  if (accepted >= 0) {
    host_ = Descriptor(accepted, "accept");
    send_line(hello_);
  }
}

/// The few bytes of a line always fit into the buffer of a socket whose host takes turns with us;
/// a host that is gone shows at the next read.
void LockstepServer::send_line(const std::string& line) const {
  const std::string bytes = line + "\n";
  [[maybe_unused]] const ssize_t sent =
      ::send(host_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
}

}  // namespace echomap::runner

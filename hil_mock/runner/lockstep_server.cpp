// SPDX-License-Identifier: MIT
#include "hil_mock/runner/lockstep_server.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <sys/socket.h>
#include <sys/un.h>

#include "host/geometry/angle.hpp"

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

/// Whether `text` is these numbers and no more.
template <class... Number>
bool take_all(std::string_view text, Number&... numbers) {
  return (take_number(text, numbers) && ...) && text.empty();
}

/// Simulated time is counted in nanoseconds.
constexpr std::int64_t kLastMicrosecond = std::numeric_limits<std::int64_t>::max() / 1000;
/// Nobody holds a robot, or a cable that is pulled, for longer than an hour.
constexpr std::int64_t kLongestHoldUs = 3'600'000'000;
/// No room is a kilometre across, and nobody carries a larger box.
constexpr std::int64_t kFarthestMm = 1'000'000;
constexpr std::int64_t kLargestBoxMm = 10'000;

bool is_held(std::int64_t for_us) { return for_us > 0 && for_us <= kLongestHoldUs; }

bool is_sound(const PutBox& box) {
  const auto is_near = [](std::int64_t mm) { return mm >= -kFarthestMm && mm <= kFarthestMm; };
  return is_near(box.x_mm) && is_near(box.y_mm) && box.side_mm > 0 && box.side_mm <= kLargestBoxMm;
}

std::string in_millionths(double value) { return std::to_string(std::llround(1e6 * value)); }

/// Empty where there is no such request.
std::optional<LockstepRequest> read_request(std::string_view verb, std::string_view numbers) {
  Grant grant;
  if (verb == "grant" && take_all(numbers, grant.until_us, grant.host_bytes) &&
      grant.until_us <= kLastMicrosecond) {
    return grant;
  }
  CarryOff carry;
  if (verb == "carry-off" && take_all(numbers, carry.held_us) && is_held(carry.held_us)) {
    return carry;
  }
  CutCable cut;
  if (verb == "cut-cable" && take_all(numbers, cut.for_us) && is_held(cut.for_us)) {
    return cut;
  }
  PutBox box;
  if (verb == "box" && take_all(numbers, box.x_mm, box.y_mm, box.side_mm) && is_sound(box)) {
    return box;
  }
  if (verb == "tell-truth" && numbers.empty()) {
    return TellTruth{};
  }
  if (verb == "quit" && numbers.empty()) {
    return Quit{};
  }
  return std::nullopt;
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

LockstepRequest parse_request(std::string_view line) {
  const std::size_t verb_end = std::min(line.find(' '), line.size());
  const auto request = read_request(line.substr(0, verb_end), line.substr(verb_end));
  return request ? *request : BadRequest{std::string(line)};
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

void LockstepServer::send_reached(std::int64_t until_us,
                                  std::uint64_t device_bytes,
                                  const std::optional<geometry::Pose2>& T_start_robot) {
  std::string line = "reached " + std::to_string(until_us) + " " + std::to_string(device_bytes);
  if (T_start_robot) {
    line += " " + in_millionths(T_start_robot->x_m()) + " " + in_millionths(T_start_robot->y_m()) +
            " " + in_millionths(geometry::degrees(T_start_robot->heading_rad()));
  }
  send_line(line);
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

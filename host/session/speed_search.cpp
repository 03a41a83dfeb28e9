// SPDX-License-Identifier: MIT
#include "host/session/speed_search.hpp"

#include <algorithm>
#include <span>

#include "host/robot_link/robot_probe.hpp"

namespace echomap::session {
namespace {

using std::chrono::steady_clock;

/// For a Hello to the robot and its reply back, through an adapter that holds bytes for 16 ms each
/// way.
constexpr std::chrono::milliseconds kReplyPatience{100};

/// Whether a frame comes at the speed that the line has now.
bool is_answered(transport::ByteStream& stream, std::uint16_t session) {
  robot_link::RobotProbe probe(session);
  std::array<std::uint8_t, 4096> buffer{};
  stream.write(probe.hello());
  const auto until = steady_clock::now() + kReplyPatience;
  for (auto now = steady_clock::now(); now < until && !probe.hears_frames();
       now = steady_clock::now()) {
    const auto left = std::chrono::duration_cast<std::chrono::microseconds>(until - now);
    probe.receive(std::span(buffer).first(stream.read_some(buffer, left)));
    if (stream.status() != transport::StreamStatus::kOpen) {
      return false;
    }
  }
  return probe.hears_frames();
}

}  // namespace

std::optional<int> find_speed(transport::ByteStream& stream,
                              std::uint16_t session,
                              std::chrono::milliseconds patience) {
  const auto until = steady_clock::now() + patience;
  do {
    for (const int baud : kRobotBauds) {
      if (stream.set_baud(baud) && is_answered(stream, session)) {
        return baud;
      }
    }
  } while (stream.set_baud(kRobotBauds.front()) && steady_clock::now() < until);
  return std::nullopt;
}

}  // namespace echomap::session

// SPDX-License-Identifier: MIT
#include "host/transport/lockstep_channel.hpp"

#include <array>
#include <cmath>

#include "host/transport/local_stream.hpp"
#include "host/transport/transport_error.hpp"

namespace echomap::transport {

LockstepChannel::LockstepChannel(const std::string& socket_path, std::chrono::milliseconds patience)
    : stream_(open_local_stream(socket_path)), patience_(patience) {
  device_ = read_hello(socket_path);
}

DeviceInfo LockstepChannel::read_hello(const std::string& socket_path) {
  const auto line = read_line();
  const auto hello = line ? parse_lockstep_hello(*line) : std::nullopt;
  if (!hello) {
    throw TransportError("no lockstep device answers on " + socket_path,
                         line ? "its first line is: " + *line : close_reason_,
                         "start echomap-mock or echomap-simavr with --lockstep " + socket_path);
  }
  return *hello;
}

std::optional<Reached> LockstepChannel::grant(std::int64_t until_us, std::uint64_t host_bytes) {
  send_line("grant " + std::to_string(until_us) + ' ' + std::to_string(host_bytes));
  const auto line = read_line();
  if (!line) {
    return std::nullopt;
  }
  const auto reached = parse_reached(*line);
  if (!reached || reached->until_us != until_us) {
    close_reason_ = "it answered a grant with: " + *line;
    return std::nullopt;
  }
  true_pose_ = reached->true_pose;
  return reached;
}

void LockstepChannel::carry_off(std::chrono::microseconds held) {
  send_line("carry-off " + std::to_string(held.count()));
}

void LockstepChannel::cut_cable(std::chrono::microseconds away) {
  send_line("cut-cable " + std::to_string(away.count()));
}

void LockstepChannel::tell_truth() { send_line("tell-truth"); }

void LockstepChannel::put_box(double x_m, double y_m, double side_m) {
  const auto mm = [](double metres) { return ' ' + std::to_string(std::llround(1e3 * metres)); };
  send_line("box" + mm(x_m) + mm(y_m) + mm(side_m));
}

bool LockstepChannel::quit() {
  send_line("quit");
  return read_line() == "bye";
}

void LockstepChannel::send_line(const std::string& line) {
  const std::string bytes = line + '\n';
  stream_->write({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

std::optional<std::string> LockstepChannel::read_line() {
  const auto deadline = std::chrono::steady_clock::now() + patience_;
  std::array<std::uint8_t, 512> piece{};
  while (true) {
    if (const std::size_t end = received_.find('\n'); end != std::string::npos) {
      std::string line = received_.substr(0, end);
      received_.erase(0, end + 1);
      return line;
    }
    const auto left = std::chrono::duration_cast<std::chrono::microseconds>(
        deadline - std::chrono::steady_clock::now());
    if (stream_->status() == StreamStatus::kClosed || left.count() <= 0) {
      close_reason_ = stream_->status() == StreamStatus::kClosed ? stream_->close_reason()
                                                                 : "the device does not answer";
      return std::nullopt;
    }
    const std::size_t count = stream_->read_some(piece, left);
    received_.append(piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(count));
  }
}

}  // namespace echomap::transport

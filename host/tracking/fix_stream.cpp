// SPDX-License-Identifier: MIT
#include "host/tracking/fix_stream.hpp"

#include <array>
#include <utility>

#include <spdlog/spdlog.h>

#include "host/console/exit_code.hpp"
#include "host/transport/tcp_stream.hpp"
#include "host/transport/transport_error.hpp"
#include "host/transport/udp_stream.hpp"

namespace echomap::tracking {
namespace {

constexpr std::size_t kLongestLine = 4096;
/// So many at once: a sender without end cannot keep the robot waiting.
constexpr int kMaxPieces = 64;
constexpr std::size_t kShownBytes = 60;

/// What of a stranger's line can be shown on a terminal.
std::string shown(const std::string& line) {
  std::string text = line.substr(0, kShownBytes);
  for (char& letter : text) {
    letter = letter >= ' ' && letter <= '~' ? letter : '?';
  }
  return text;
}

}  // namespace

std::unique_ptr<transport::ByteStream> open_fixes(const std::string& address) {
  const std::string kind = address.substr(0, 4);
  try {
    if (kind == "udp:") {
      return transport::open_udp_stream("udp://" + address.substr(4));
    }
    if (kind == "tcp:") {
      return transport::open_tcp_stream("tcp://" + address.substr(4));
    }
  } catch (const transport::TransportError& error) {
    throw console::CommandError(console::ExitCode::kRuntimeError,
                                std::string("no pose measurements: ") + error.what());
  }
  throw console::CommandError(console::ExitCode::kUsage,
                              "--fixes " + address +
                                  " is neither udp:HOST:PORT nor tcp:HOST:PORT\n"
                                  "  next: --fixes udp:127.0.0.1:7001");
}

std::vector<TimedFix> FixStream::take(time::HostTime now) {
  std::vector<TimedFix> fixes;
  std::array<std::uint8_t, kLongestLine> piece{};
  for (int pieces = 0; pieces < kMaxPieces; ++pieces) {
    const std::size_t count = stream_->read_some(piece, std::chrono::microseconds(0));
    if (count == 0) {
      break;
    }
    take_piece({piece.data(), count}, now, fixes);
  }
  if (stream_->status() == transport::StreamStatus::kClosed && !std::exchange(end_is_told_, true)) {
    spdlog::warn("no more pose measurements: {}: {}", name(), stream_->close_reason());
  }
  return fixes;
}

void FixStream::take_piece(std::span<const std::uint8_t> piece,
                           time::HostTime now,
                           std::vector<TimedFix>& fixes) {
  for (const std::uint8_t byte : piece) {
    const char letter = static_cast<char>(byte);
    if (letter == '\n') {
      take_line(std::exchange(received_, {}), now, fixes);
    } else if (received_.size() < kLongestLine) {
      received_.push_back(letter);
    } else {
      skips_line_ = true;
    }
  }
}

void FixStream::take_line(const std::string& line,
                          time::HostTime now,
                          std::vector<TimedFix>& fixes) {
  const bool is_whole = !std::exchange(skips_line_, false);
  const auto fix = is_whole ? parse_camera_fix(line) : std::nullopt;
  if (!fix) {
    report_malformed(line, "is not a pose");
    return;
  }
  if (!clock_.add(fix->sent_s, now)) {
    report_malformed(line, "has a time stamp of another clock");
    return;
  }
  ++fixes_;
  fixes.push_back({clock_.host_time(fix->stamp_s).value_or(now), *fix});
}

void FixStream::report_malformed(const std::string& line, std::string_view what) {
  if (++bad_lines_ == 1) {
    spdlog::warn("{} sent a line that {} (reported once): {}", name(), what, shown(line));
  }
}

}  // namespace echomap::tracking

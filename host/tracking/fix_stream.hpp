// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/time/host_time.hpp"
#include "host/time/sender_clock.hpp"
#include "host/tracking/camera_fix.hpp"
#include "host/transport/byte_stream.hpp"

namespace echomap::tracking {

/// A fix whose picture was taken at that instant of the host's clock.
struct TimedFix {
  time::HostTime taken;
  CameraFix fix;
};

/// Opens "udp:HOST:PORT", where it listens, or "tcp:HOST:PORT", where it connects to. Throws
/// CommandError 1 with what is wrong and what to do.
std::unique_ptr<transport::ByteStream> open_fixes(const std::string& address);

/// The lines of an overhead camera. A line that is none, or that was sent more than a second
/// off by the clock of those before, is counted, and the first is shown.
class FixStream {
 public:
  explicit FixStream(std::unique_ptr<transport::ByteStream> stream) : stream_(std::move(stream)) {}

  /// The fixes that have come since the last call, in the order of their coming. Does not wait; of
  /// a great many the rest comes with the next calls.
  std::vector<TimedFix> take(time::HostTime now);

  std::size_t fixes() const { return fixes_; }
  std::size_t bad_lines() const { return bad_lines_; }
  std::string name() const { return stream_->name(); }

 private:
  void take_piece(std::span<const std::uint8_t> piece,
                  time::HostTime now,
                  std::vector<TimedFix>& fixes);
  void take_line(const std::string& line, time::HostTime now, std::vector<TimedFix>& fixes);
  void report_malformed(const std::string& line, std::string_view what);

  std::unique_ptr<transport::ByteStream> stream_;
  time::SenderClock clock_;
  std::string received_;
  bool skips_line_ = false;  ///< It is too long.
  bool end_is_told_ = false;
  std::size_t fixes_ = 0;
  std::size_t bad_lines_ = 0;
};

}  // namespace echomap::tracking

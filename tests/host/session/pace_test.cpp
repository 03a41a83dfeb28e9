// SPDX-License-Identifier: MIT
#include "host/session/pace.hpp"

#include <algorithm>
#include <deque>

#include <gtest/gtest.h>

namespace echomap::session {
namespace {

/// A stream that holds what the test put into it.
class PreparedStream final : public transport::ByteStream {
 public:
  std::deque<std::uint8_t> bytes;

  std::size_t read_some(std::span<std::uint8_t> into, std::chrono::microseconds) override {
    const std::size_t count = std::min(into.size(), bytes.size());
    std::copy_n(bytes.begin(), count, into.begin());
    bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  void write(std::span<const std::uint8_t>) override {}
  transport::StreamStatus status() const override { return transport::StreamStatus::kOpen; }
  std::string close_reason() const override { return {}; }
  std::string name() const override { return "prepared"; }
};

TEST(RealTimePace, NeverRunsBackAndHandsOverBytes) {
  PreparedStream stream;
  stream.bytes = {1, 2, 3};
  const auto pace = real_time_pace();
  std::size_t received = 0;
  const auto count = [&](std::span<const std::uint8_t> bytes) { received += bytes.size(); };
  const auto first = pace->step(stream, 0, count);
  const auto second = pace->step(stream, 0, count);
  EXPECT_GE(second, first);
  EXPECT_EQ(received, 3U);
  EXPECT_EQ(pace->end_reason(), "");
}

}  // namespace
}  // namespace echomap::session

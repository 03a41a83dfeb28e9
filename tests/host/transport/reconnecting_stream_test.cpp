// SPDX-License-Identifier: MIT
#include "host/transport/reconnecting_stream.hpp"

#include <memory>

#include <gtest/gtest.h>

#include "host/transport/pty_port.hpp"
#include "host/transport/transport_error.hpp"
#include "tests/host/transport/pty_pair.hpp"

namespace echomap::transport {
namespace {

/// A device that can be pulled out and put in again under another name, as USB does it.
class ReconnectingStreamTest : public testing::Test {
 protected:
  std::unique_ptr<ByteStream> open() {
    if (!device) {
      throw TransportError("cannot open it", "it is gone", "put it in");
    }
    return open_pty_port(device->name());
  }
  /// Reads until the stream's status is `status`; false after five seconds.
  bool becomes(StreamStatus status) {
    std::array<std::uint8_t, 16> into{};
    for (int i = 0; i < 500 && stream->status() != status; ++i) {
      stream->read_some(into, std::chrono::milliseconds(10));
    }
    return stream->status() == status;
  }

  std::unique_ptr<PtyPair> device = std::make_unique<PtyPair>();
  std::unique_ptr<ReconnectingStream> stream =
      std::make_unique<ReconnectingStream>(open(), [this] { return open(); });
};

TEST_F(ReconnectingStreamTest, ComesBackWithItsDeviceEveryTime) {
  for (std::uint64_t i = 1; i <= 5; ++i) {
    device.reset();
    ASSERT_TRUE(becomes(StreamStatus::kAway)) << i;
    EXPECT_FALSE(stream->close_reason().empty());
    device = std::make_unique<PtyPair>();
    ASSERT_TRUE(becomes(StreamStatus::kOpen)) << i;
    EXPECT_TRUE(stream->close_reason().empty());
    EXPECT_EQ(stream->reconnects(), i);
    device->write(counting_bytes(100));
    EXPECT_EQ(read_bytes(*stream, 100), counting_bytes(100));
    stream->write(counting_bytes(50));
    EXPECT_EQ(device->read(50), counting_bytes(50));
  }
}

TEST_F(ReconnectingStreamTest, DropsWhatIsWrittenWhileAway) {
  device.reset();
  ASSERT_TRUE(becomes(StreamStatus::kAway));
  stream->write(counting_bytes(10));
  EXPECT_EQ(stream->status(), StreamStatus::kAway);
  EXPECT_EQ(stream->close_reason(), "the other end closed it");
  std::array<std::uint8_t, 16> into{};
  stream->read_some(into, std::chrono::milliseconds(500));
  EXPECT_EQ(stream->close_reason(), "it is gone");
}

}  // namespace
}  // namespace echomap::transport

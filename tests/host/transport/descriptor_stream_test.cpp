// SPDX-License-Identifier: MIT
#include "host/transport/descriptor_stream.hpp"

#include <algorithm>
#include <fcntl.h>
#include <random>
#include <unistd.h>

#include <gtest/gtest.h>
#include <sys/socket.h>

#include "host/transport/file_descriptor.hpp"
#include "tests/host/transport/pty_pair.hpp"

namespace echomap::transport {
namespace {

class DescriptorStreamTest : public testing::Test {
 protected:
  void SetUp() override {
    std::array<int, 2> ends{};
    ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()), 0);
    host_fd = ends[0];
    stream = descriptor_stream(ends[0], "one end");
    device = std::make_unique<FileDescriptor>(ends[1]);
  }

  void send(std::span<const std::uint8_t> bytes) {
    ASSERT_EQ(::write(device->get(), bytes.data(), bytes.size()),
              static_cast<ssize_t>(bytes.size()));
  }

  int host_fd = -1;
  std::unique_ptr<ByteStream> stream;
  std::unique_ptr<FileDescriptor> device;
};

TEST_F(DescriptorStreamTest, KeepsOrderWhateverTheSizesOfReadsAndWrites) {
  std::mt19937 random(6);
  const auto sent = counting_bytes(100'000);
  std::vector<std::uint8_t> received;
  std::size_t written = 0;
  while (received.size() < sent.size()) {
    const std::size_t count = std::min<std::size_t>(random() % 9000, sent.size() - written);
    send(std::span(sent).subspan(written, count));
    written += count;
    while (received.size() < written) {
      std::vector<std::uint8_t> piece(1 + random() % 6000);
      const std::size_t got = stream->read_some(piece, std::chrono::seconds(5));
      ASSERT_GT(got, 0U);
      received.insert(received.end(), piece.begin(), piece.begin() + static_cast<long>(got));
    }
  }
  EXPECT_EQ(received, sent);
}

TEST_F(DescriptorStreamTest, ReadsWhatIsThereWithoutWaiting) {
  std::array<std::uint8_t, 16> into{};
  EXPECT_EQ(stream->read_some(into, std::chrono::microseconds(0)), 0U);
  send(counting_bytes(10));
  EXPECT_EQ(stream->read_some(into, std::chrono::microseconds(0)), 10U);
  EXPECT_EQ(stream->read_some(into, std::chrono::microseconds(0)), 0U);
}

TEST_F(DescriptorStreamTest, KeepsBytesThatCameDuringAWrite) {
  std::array<std::uint8_t, 16> into{};
  stream->read_some(into, std::chrono::microseconds(0));
  send(counting_bytes(10));
  stream->write(counting_bytes(5));
  EXPECT_EQ(read_bytes(*stream, 10), counting_bytes(10));
}

TEST_F(DescriptorStreamTest, ClosesItsDescriptorWithItself) {
  EXPECT_NE(::fcntl(host_fd, F_GETFD), -1);
  stream.reset();
  EXPECT_EQ(::fcntl(host_fd, F_GETFD), -1);
}

TEST_F(DescriptorStreamTest, IsClosedWhenTheOtherEndIs) {
  device.reset();
  EXPECT_TRUE(read_bytes(*stream, 1).empty());
  EXPECT_EQ(stream->status(), StreamStatus::kClosed);
}

}  // namespace
}  // namespace echomap::transport

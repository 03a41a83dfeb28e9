// SPDX-License-Identifier: MIT
#include "hil_mock/runner/outgoing_bytes.hpp"

#include <array>
#include <csignal>
#include <cstdint>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "hil_mock/runner/descriptor.hpp"

namespace echomap::runner {
namespace {

class OutgoingBytesTest : public testing::Test {
 protected:
  void SetUp() override {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    reader = Descriptor(ends[0], "pipe");
    writer = Descriptor(ends[1], "pipe");
    set_non_blocking(reader.number());
    set_non_blocking(writer.number());
  }

  std::vector<std::uint8_t> drain() {
    std::vector<std::uint8_t> bytes(1 << 20);
    const ssize_t count = ::read(reader.number(), bytes.data(), bytes.size());
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }

  Descriptor reader;
  Descriptor writer;
};

std::vector<std::uint8_t> pattern(std::size_t size) {
  std::vector<std::uint8_t> bytes(size);
  for (std::size_t i = 0; i < size; ++i) {
    bytes[i] = static_cast<std::uint8_t>(i * 31 + i / 256);
  }
  return bytes;
}

TEST_F(OutgoingBytesTest, KeptBytesAllComeThroughAFullPipeInOrder) {
  OutgoingBytes outgoing(WhenUnread::kKeep);
  const auto all = pattern(300'000);
  outgoing.push(all);
  std::vector<std::uint8_t> arrived;
  while (arrived.size() < all.size()) {
    ASSERT_TRUE(outgoing.write_to(writer.number()));
    const auto piece = drain();
    ASSERT_FALSE(piece.empty());
    arrived.insert(arrived.end(), piece.begin(), piece.end());
  }
  EXPECT_EQ(arrived, all);
  EXPECT_TRUE(outgoing.empty());
  EXPECT_EQ(outgoing.dropped(), 0U);
}

TEST_F(OutgoingBytesTest, BeyondItsBoundUnreadBytesAreDroppedAndCounted) {
  OutgoingBytes outgoing(WhenUnread::kDrop);
  const auto all = pattern(5000);
  outgoing.push(all);
  EXPECT_EQ(outgoing.dropped(), 5000U - 4096U);
  ASSERT_TRUE(outgoing.write_to(writer.number()));
  EXPECT_EQ(drain(), std::vector<std::uint8_t>(all.begin(), all.begin() + 4096));
}

TEST_F(OutgoingBytesTest, DiscardedBytesCountAsDropped) {
  OutgoingBytes outgoing(WhenUnread::kKeep);
  outgoing.push(pattern(10));
  outgoing.discard();
  EXPECT_EQ(outgoing.dropped(), 10U);
  EXPECT_TRUE(outgoing.empty());
}

TEST_F(OutgoingBytesTest, TellsThatTheOtherEndIsGone) {
  std::signal(SIGPIPE, SIG_IGN);
  OutgoingBytes outgoing(WhenUnread::kKeep);
  outgoing.push(pattern(10));
  reader.close();
  EXPECT_FALSE(outgoing.write_to(writer.number()));
}

}  // namespace
}  // namespace echomap::runner

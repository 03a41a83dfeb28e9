// SPDX-License-Identifier: MIT
#include "hil_mock/runner/wait_readable.hpp"

#include <array>
#include <chrono>
#include <unistd.h>

#include <gtest/gtest.h>

#include "hil_mock/runner/descriptor.hpp"
#include "hil_mock/runner/tcp_endpoint.hpp"

namespace echomap::runner {
namespace {

// Without a look at the other descriptor this would run into the test's time limit.
TEST(WaitReadable, EndsWhenTheOtherDescriptorIsReadable) {
  const TcpEndpoint endpoint(0, WhenUnread::kDrop);
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const Descriptor reader(ends[0], "pipe");
  const Descriptor writer(ends[1], "pipe");
  ASSERT_EQ(::write(writer.number(), "x", 1), 1);
  wait_readable(endpoint, reader.number(), std::chrono::hours(1));
  char byte = 0;
  EXPECT_EQ(::read(reader.number(), &byte, 1), 1);
}

TEST(WaitReadable, EndsWhenItsTimeIsOver) {
  const TcpEndpoint endpoint(0, WhenUnread::kDrop);
  const auto begin = std::chrono::steady_clock::now();
  wait_readable(endpoint, -1, std::chrono::milliseconds(20));
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(19));
}

}  // namespace
}  // namespace echomap::runner

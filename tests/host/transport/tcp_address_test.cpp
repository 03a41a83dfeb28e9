// SPDX-License-Identifier: MIT
#include "host/transport/tcp_address.hpp"

#include <gtest/gtest.h>

namespace echomap::transport {
namespace {

TEST(TcpAddress, HasAHostAndAPort) {
  const auto address = parse_tcp_address("tcp://robot.local:5000");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->host, "robot.local");
  EXPECT_EQ(address->port, "5000");
}

TEST(TcpAddress, TakesIpv6InBracketsOnly) {
  const auto address = parse_tcp_address("tcp://[::1]:80");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->host, "::1");
  EXPECT_FALSE(parse_tcp_address("tcp://::1:80"));
  for (const char* wrong : {"tcp://[::1:80", "tcp://[]:80", "tcp://[[c]]:80", "tcp://a]:80"}) {
    EXPECT_FALSE(parse_tcp_address(wrong)) << wrong;
  }
}

TEST(TcpAddress, IsNoneWithoutAHostOrAPortFrom1To65535) {
  for (const char* wrong : {"tcp://",
                            "tcp://host",
                            "tcp://host:",
                            "tcp://:5000",
                            "tcp://host:0",
                            "tcp://host:65536",
                            "tcp://host:-1",
                            "tcp://host:5000x",
                            "tcp://host: 5000",
                            "host:5000",
                            "/dev/ttyACM0"}) {
    EXPECT_FALSE(parse_tcp_address(wrong)) << wrong;
  }
  EXPECT_TRUE(parse_tcp_address("tcp://host:65535"));
}

TEST(TcpAddress, IsToldByItsScheme) {
  EXPECT_TRUE(is_tcp_address("tcp://"));
  EXPECT_FALSE(is_tcp_address("tcp:/"));
  EXPECT_FALSE(is_tcp_address("/dev/tcp://x"));
}

}  // namespace
}  // namespace echomap::transport

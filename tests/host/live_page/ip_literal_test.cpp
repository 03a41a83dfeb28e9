// SPDX-License-Identifier: MIT
#include "host/live_page/ip_literal.hpp"

#include <string>

#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

TEST(IpLiteral, IsANumberNoName) {
  for (const char* text :
       {"", "localhost", "127.1", "1.2.3.4.5", "256.0.0.1", "[::1]", "::g", " ::1"}) {
    EXPECT_FALSE(IpLiteral::parse(text)) << text;
  }
  EXPECT_FALSE(IpLiteral::parse(std::string("127.0.0.1\0x", 11)));
  EXPECT_TRUE(IpLiteral::parse("192.168.1.5"));
  EXPECT_TRUE(IpLiteral::parse("fe80::1")->is_v6());
}

TEST(IpLiteral, IsTheSameHoweverItIsWritten) {
  EXPECT_EQ(IpLiteral::parse("::1"), IpLiteral::parse("0:0:0:0:0:0:0:1"));
  EXPECT_NE(IpLiteral::parse("0.0.0.0"), IpLiteral::parse("::"));
}

TEST(IpLiteral, KnowsLoopbackAndAny) {
  EXPECT_TRUE(IpLiteral::parse("127.0.0.1")->is_loopback());
  EXPECT_TRUE(IpLiteral::parse("127.9.9.9")->is_loopback());
  EXPECT_TRUE(IpLiteral::parse("::1")->is_loopback());
  EXPECT_FALSE(IpLiteral::parse("192.168.1.5")->is_loopback());
  EXPECT_FALSE(IpLiteral::parse("::ffff:127.0.0.1")->is_loopback());
  EXPECT_TRUE(IpLiteral::parse("0.0.0.0")->is_any());
  EXPECT_TRUE(IpLiteral::parse("::")->is_any());
  EXPECT_FALSE(IpLiteral::parse("::1")->is_any());
}

TEST(HostAndPort, AreTakenApart) {
  EXPECT_EQ(HostAndPort::parse("Host.example"), (HostAndPort{"host.example", 80}));
  EXPECT_EQ(HostAndPort::parse("1.2.3.4:65535"), (HostAndPort{"1.2.3.4", 65535}));
  EXPECT_EQ(HostAndPort::parse("[::1]:8080"), (HostAndPort{"::1", 8080}));
  EXPECT_EQ(HostAndPort::parse("[::1]"), (HostAndPort{"::1", 80}));
  for (const char* text : {"",
                           ":80",
                           "[]:80",
                           "[::1",
                           "::1",
                           "host:",
                           "host:x",
                           "host:-1",
                           "host:65536",
                           "host:80x",
                           "host:80:80",
                           "[::1]x"}) {
    EXPECT_FALSE(HostAndPort::parse(text)) << text;
  }
}

}  // namespace
}  // namespace echomap::live_page

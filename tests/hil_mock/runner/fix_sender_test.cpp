// SPDX-License-Identifier: MIT
#include "hil_mock/runner/fix_sender.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <unistd.h>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "hil_mock/runner/descriptor.hpp"

namespace echomap::runner {
namespace {

TEST(FixSender, SendsDatagramsToThisMachine) {
  const Descriptor socket(::socket(AF_INET, SOCK_DGRAM, 0), "socket");
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* generic = reinterpret_cast<sockaddr*>(&address);
  check_call(::bind(socket.number(), generic, size), "bind");
  check_call(::getsockname(socket.number(), generic, &size), "getsockname");

  make_fix_sender("udp:" + std::to_string(ntohs(address.sin_port)))->send("a line");
  std::array<char, 64> text{};
  const ssize_t count = ::recv(socket.number(), text.data(), text.size(), 0);
  EXPECT_EQ(std::string(text.data(), static_cast<std::size_t>(count)), "a line");
}

TEST(FixSender, LosesWhatNobodyHears) {
  EXPECT_NO_THROW(make_fix_sender("tcp:0")->send("a line"));
  EXPECT_NO_THROW(make_fix_sender("udp:9")->send("a line"));
}

TEST(FixSender, RefusesAnotherAddress) {
  for (const char* wrong : {"", "udp", "udp:", "udp:0", "udp:x", "udp:70000", "tcp:1x", "ftp:1"}) {
    EXPECT_THROW(make_fix_sender(wrong), std::invalid_argument) << wrong;
  }
}

}  // namespace
}  // namespace echomap::runner

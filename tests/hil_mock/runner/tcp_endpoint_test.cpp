// SPDX-License-Identifier: MIT
#include "hil_mock/runner/tcp_endpoint.hpp"

#include <chrono>
#include <string>
#include <system_error>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>

#include "hil_mock/runner/wait_readable.hpp"
#include "tests/hil_mock/runner/endpoint_text.hpp"
#include "tests/hil_mock/runner/test_host.hpp"

namespace echomap::runner {
namespace {

std::uint16_t port_of(const TcpEndpoint& endpoint) {
  const std::string address = endpoint.address();
  return static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
}

TestHost connect_to(const TcpEndpoint& endpoint) {
  Descriptor socket(::socket(AF_INET, SOCK_STREAM, 0), "socket");
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port_of(endpoint));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  check_call(
      ::connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address),
      "connect");
  return TestHost(std::move(socket));
}

TEST(TcpEndpoint, EveryByteValuePassesBothWays) {
  TcpEndpoint endpoint(0, WhenUnread::kDrop);
  EXPECT_EQ(endpoint.address().rfind("tcp://127.0.0.1:", 0), 0U);
  TestHost host = connect_to(endpoint);
  host.write(all_bytes());
  EXPECT_EQ(receive_all(endpoint, 256), all_bytes());
  send_text(endpoint, all_bytes());
  EXPECT_EQ(host.read(256), all_bytes());
}

TEST(TcpEndpoint, ServesTheNextHostAfterOneHasGone) {
  TcpEndpoint endpoint(0, WhenUnread::kDrop);
  for (const std::string text : {"first", "second"}) {
    TestHost host = connect_to(endpoint);
    host.write(text);
    EXPECT_EQ(receive_all(endpoint, text.size()), text);
    host.close();
    wait_readable(endpoint, -1, std::chrono::seconds(5));
    EXPECT_TRUE(endpoint.receive().empty()) << "sees the end and listens again";
  }
}

TEST(TcpEndpoint, HearsEveryHostAndIsHeardByEach) {
  TcpEndpoint endpoint(0, WhenUnread::kDrop);
  TestHost first = connect_to(endpoint);
  first.write("one");
  EXPECT_EQ(receive_all(endpoint, 3), "one");
  TestHost second = connect_to(endpoint);
  second.write("two");
  EXPECT_EQ(receive_all(endpoint, 3), "two");
  send_text(endpoint, "to both");
  EXPECT_EQ(first.read(7), "to both");
  EXPECT_EQ(second.read(7), "to both");
}

TEST(TcpEndpoint, WithoutAHostBytesAreDroppedOrKept) {
  TcpEndpoint dropping(0, WhenUnread::kDrop);
  send_text(dropping, "lost");
  EXPECT_EQ(dropping.dropped_bytes(), 4U);
  TcpEndpoint keeping(0, WhenUnread::kKeep);
  send_text(keeping, "kept");
  TestHost host = connect_to(keeping);
  wait_readable(keeping, -1, std::chrono::seconds(5));
  keeping.receive();
  keeping.send({});
  EXPECT_EQ(host.read(4), "kept");
}

TEST(TcpEndpoint, RefusesAPortThatIsTaken) {
  const TcpEndpoint first(0, WhenUnread::kDrop);
  EXPECT_THROW(TcpEndpoint(port_of(first), WhenUnread::kDrop), std::system_error);
}

}  // namespace
}  // namespace echomap::runner

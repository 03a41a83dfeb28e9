// SPDX-License-Identifier: MIT
#include "tests/support/tcp_proxy.hpp"

#include <chrono>
#include <string>
#include <thread>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <gtest/gtest.h>

#include "tests/support/eventually.hpp"

namespace echomap::tests {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using Clock = std::chrono::steady_clock;

/// A server, and a client that is connected to it through the proxy.
class ThroughAProxy : public testing::Test {
 protected:
  ThroughAProxy() {
    client_.connect({asio::ip::address_v4::loopback(), proxy_.port()});
    server_ = acceptor_.accept();
  }

  static void send(tcp::socket& socket, const std::string& text) {
    asio::write(socket, asio::buffer(text));
  }
  static std::string receive(tcp::socket& socket, std::size_t size) {
    std::string text(size, '\0');
    asio::read(socket, asio::buffer(text));
    return text;
  }
  static boost::system::error_code read_error(tcp::socket& socket) {
    boost::system::error_code error;
    char byte = 0;
    asio::read(socket, asio::buffer(&byte, 1), error);
    return error;
  }

  asio::io_context io_;
  tcp::acceptor acceptor_{io_, {asio::ip::address_v4::loopback(), 0}};
  TcpProxy proxy_{acceptor_.local_endpoint().port()};
  tcp::socket client_{io_};
  tcp::socket server_{io_};
};

TEST_F(ThroughAProxy, EveryByteGoesBothWays) {
  std::string large;
  for (int i = 0; large.size() < 3'000'000; ++i) {
    large += std::to_string(i) + " ";
  }
  std::thread sender([&] { send(client_, large); });
  EXPECT_EQ(receive(server_, large.size()), large);
  sender.join();
  send(server_, "pong");
  EXPECT_EQ(receive(client_, 4), "pong");
  EXPECT_TRUE(eventually([&] { return proxy_.passed_bytes() == large.size() + 4; }));
  EXPECT_EQ(proxy_.connections(), 1U);
}

TEST_F(ThroughAProxy, ADelayIsThatOfEachDirection) {
  proxy_.set_delay(std::chrono::milliseconds(60));
  const auto begin = Clock::now();
  send(client_, "ping");
  EXPECT_EQ(receive(server_, 4), "ping");
  EXPECT_GE(Clock::now() - begin, std::chrono::milliseconds(60));
  send(server_, "pong");
  EXPECT_EQ(receive(client_, 4), "pong");
  EXPECT_GE(Clock::now() - begin, std::chrono::milliseconds(120));
}

TEST_F(ThroughAProxy, AStallKeepsConnectionAndBytes) {
  proxy_.stall();
  send(client_, "ping");
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(server_.available(), 0U);
  proxy_.resume();
  EXPECT_EQ(receive(server_, 4), "ping");
}

TEST_F(ThroughAProxy, ACutResetsBothEndsAndThoseWhoComeMeanwhile) {
  proxy_.cut();
  EXPECT_EQ(read_error(client_), asio::error::connection_reset);
  EXPECT_EQ(read_error(server_), asio::error::connection_reset);
  tcp::socket early(io_);
  early.connect({asio::ip::address_v4::loopback(), proxy_.port()});
  EXPECT_EQ(read_error(early), asio::error::connection_reset);

  proxy_.resume();
  tcp::socket late(io_);
  late.connect({asio::ip::address_v4::loopback(), proxy_.port()});
  tcp::socket server = acceptor_.accept();
  send(late, "ping");
  EXPECT_EQ(receive(server, 4), "ping");
}

TEST_F(ThroughAProxy, AnEndIsPassedOnBehindTheLastByte) {
  send(server_, "last");
  server_.close();
  EXPECT_EQ(receive(client_, 4), "last");
  EXPECT_EQ(read_error(client_), asio::error::eof);
}

TEST_F(ThroughAProxy, WithoutATargetAConnectionEnds) {
  acceptor_.close();
  tcp::socket client(io_);
  client.connect({asio::ip::address_v4::loopback(), proxy_.port()});
  EXPECT_EQ(read_error(client), asio::error::connection_reset);
}

}  // namespace
}  // namespace echomap::tests

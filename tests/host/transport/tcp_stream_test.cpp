// SPDX-License-Identifier: MIT
#include "host/transport/tcp_stream.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include "host/transport/asio_stream.hpp"
#include "host/transport/transport_error.hpp"
#include "tests/host/transport/pty_pair.hpp"

namespace echomap::transport {
namespace {

using boost::asio::ip::tcp;
using testing::HasSubstr;

class TcpStreamTest : public testing::Test {
 protected:
  std::string address() const {
    return "tcp://127.0.0.1:" + std::to_string(acceptor.local_endpoint().port());
  }

  boost::asio::io_context io;
  tcp::acceptor acceptor{io, tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0)};
};

TEST_F(TcpStreamTest, CarriesEveryByteBothWays) {
  const auto stream = open_tcp_stream(address());
  tcp::socket device = acceptor.accept();
  const auto bytes = counting_bytes(10'000);
  stream->write(bytes);
  std::vector<std::uint8_t> received(10'000);
  boost::asio::read(device, boost::asio::buffer(received));
  EXPECT_EQ(received, bytes);
  boost::asio::write(device, boost::asio::buffer(bytes));
  EXPECT_EQ(read_bytes(*stream, 10'000), bytes);
  EXPECT_EQ(stream->name(), address());
}

TEST_F(TcpStreamTest, GivesTheLastBytesBeforeItSaysThatTheDeviceIsGone) {
  const auto stream = open_tcp_stream(address());
  {
    tcp::socket device = acceptor.accept();
    boost::asio::write(device, boost::asio::buffer(counting_bytes(300)));
  }
  EXPECT_EQ(read_bytes(*stream, 301), counting_bytes(300));
  EXPECT_EQ(stream->status(), StreamStatus::kClosed);
  EXPECT_EQ(stream->close_reason(), "the other end closed it");
}

TEST_F(TcpStreamTest, LetsTheKernelEndAHalfOpenConnectionInTwoSeconds) {
  const auto stream = open_tcp_stream(address());
  auto& socket = dynamic_cast<AsioStream<tcp::socket>&>(*stream).stream();
  const auto option = [&](int level, int name) {
    int value = -1;
    socklen_t size = sizeof value;
    EXPECT_EQ(::getsockopt(socket.native_handle(), level, name, &value, &size), 0);
    return value;
  };
  EXPECT_EQ(option(SOL_SOCKET, SO_KEEPALIVE), 1);
  EXPECT_EQ(option(IPPROTO_TCP, TCP_KEEPIDLE), 1);
  EXPECT_EQ(option(IPPROTO_TCP, TCP_KEEPINTVL), 1);
  EXPECT_EQ(option(IPPROTO_TCP, TCP_USER_TIMEOUT), 2000);
}

TEST_F(TcpStreamTest, SaysThatNobodyListens) {
  const std::string nobody = address();
  acceptor.close();
  try {
    open_tcp_stream(nobody);
    FAIL() << "it opened";
  } catch (const TransportError& error) {
    EXPECT_THAT(error.failure(), HasSubstr(nobody));
    EXPECT_EQ(error.why(), "Connection refused");
  }
}

TEST_F(TcpStreamTest, SaysThatAnAddressIsNone) {
  EXPECT_THROW(open_tcp_stream("tcp://nowhere"), TransportError);
}

}  // namespace
}  // namespace echomap::transport

// SPDX-License-Identifier: MIT
#include "host/transport/udp_stream.hpp"

#include <array>
#include <string>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <gtest/gtest.h>

#include "host/transport/transport_error.hpp"

namespace echomap::transport {
namespace {

using boost::asio::ip::udp;

/// A port of this machine that nobody has.
std::uint16_t free_port() {
  boost::asio::io_context io;
  const udp::socket socket(io, udp::endpoint(boost::asio::ip::make_address("127.0.0.1"), 0));
  return socket.local_endpoint().port();
}

class UdpStreamTest : public ::testing::Test {
 protected:
  void send(const std::string& text) {
    socket_.send_to(boost::asio::buffer(text),
                    udp::endpoint(boost::asio::ip::make_address("127.0.0.1"), port_));
  }
  std::string read(std::chrono::microseconds wait = std::chrono::seconds(5)) {
    std::array<std::uint8_t, 8192> piece{};
    const std::size_t count = stream_->read_some(piece, wait);
    return {piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(count)};
  }

  std::uint16_t port_ = free_port();
  std::string address_ = "udp://127.0.0.1:" + std::to_string(port_);
  std::unique_ptr<ByteStream> stream_ = open_udp_stream(address_);

 private:
  boost::asio::io_context io_;
  udp::socket socket_{io_, udp::v4()};
};

TEST_F(UdpStreamTest, ReadsEachDatagramAsALine) {
  send("one");
  send("two\n");
  EXPECT_EQ(read(), "one\n");
  EXPECT_EQ(read(), "two\n");
  EXPECT_EQ(read(std::chrono::milliseconds(1)), "");
  EXPECT_EQ(stream_->status(), StreamStatus::kOpen);
}

TEST_F(UdpStreamTest, CutsOffWhatIsTooLong) {
  send(std::string(5000, 'x'));
  send("next");
  EXPECT_EQ(read().size(), 4097U);
  EXPECT_EQ(read(), "next\n");
}

TEST_F(UdpStreamTest, PassesOverAnEmptyDatagramWithoutWaiting) {
  send("one");
  send("");
  send("two");
  EXPECT_EQ(read(), "one\n");
  EXPECT_EQ(read(std::chrono::microseconds(0)), "two\n");
  EXPECT_EQ(read(std::chrono::microseconds(0)), "");
}

TEST_F(UdpStreamTest, RefusesAPortThatIsTaken) {
  EXPECT_THROW(open_udp_stream(address_), TransportError);
}

TEST(UdpStream, RefusesWhatIsNoAddressOfThisMachine) {
  for (const char* wrong : {"udp://",
                            "udp://127.0.0.1",
                            "udp://127.0.0.1:0",
                            "udp://host:99999",
                            "udp://some.where:7001",
                            "tcp://127.0.0.1:7001",
                            "127.0.0.1:7001"}) {
    EXPECT_THROW(open_udp_stream(wrong), TransportError) << wrong;
  }
}

}  // namespace
}  // namespace echomap::transport

// SPDX-License-Identifier: MIT
#include "host/transport/tcp_stream.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>

#include "host/transport/asio_stream.hpp"
#include "host/transport/tcp_address.hpp"
#include "host/transport/transport_error.hpp"

namespace echomap::transport {
namespace {

using boost::asio::ip::tcp;
constexpr std::chrono::seconds kPatience{5};

[[noreturn]] void fail(const std::string& address, const std::string& why) {
  throw TransportError("cannot connect to " + address,
                       why,
                       "check that the robot's bridge or emulator listens there, as in "
                       "tcp://127.0.0.1:5000");
}

/// Connects within kPatience; the error of the last address that was tried.
boost::system::error_code connect(AsioStream<tcp::socket>& stream, const TcpAddress& address) {
  boost::system::error_code error;
  const auto endpoints =
      tcp::resolver(stream.io_context()).resolve(address.host, address.port, error);
  if (error) {
    return error;
  }
  return connect_within(stream, kPatience, [&](auto handler) {
    boost::asio::async_connect(stream.stream(), endpoints, handler);
  });
}

}  // namespace

std::unique_ptr<ByteStream> open_tcp_stream(const std::string& address) {
  const auto parsed = parse_tcp_address(address);
  if (!parsed) {
    fail(address, "it is not of the form tcp://host:port");
  }
  auto stream = std::make_unique<AsioStream<tcp::socket>>(address);
  if (const auto error = connect(*stream, *parsed)) {
    fail(address, error.message());
  }
  stream->stream().set_option(tcp::no_delay(true));
  return stream;
}

}  // namespace echomap::transport

// SPDX-License-Identifier: MIT
#include "host/transport/tcp_stream.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include "host/transport/asio_stream.hpp"
#include "host/transport/bounded_call.hpp"
#include "host/transport/tcp_address.hpp"
#include "host/transport/transport_error.hpp"

namespace echomap::transport {
namespace {

using boost::asio::ip::tcp;
constexpr std::chrono::seconds kTcpPatience{5};

[[noreturn]] void fail_to_reach_host(const std::string& address, const std::string& why) {
  throw TransportError(
      "cannot connect to " + address,
      why,
      "check that the robot's bridge or emulator listens there, as in tcp://127.0.0.1:5000");
}

/// A half-open connection, as after a bridge has lost its power, says nothing of itself: bytes that
/// are not acknowledged, or without any probes that are not, end it.
constexpr std::chrono::milliseconds kHalfOpenLimit{2000};
constexpr int kKeepAlivePeriodS = 1;

void set_option(tcp::socket& socket, int name, int value) {
  ::setsockopt(socket.native_handle(), IPPROTO_TCP, name, &value, sizeof value);
}

void notice_half_open(tcp::socket& socket) {
  socket.set_option(tcp::socket::keep_alive(true));
  set_option(socket, TCP_KEEPIDLE, kKeepAlivePeriodS);
  set_option(socket, TCP_KEEPINTVL, kKeepAlivePeriodS);
  set_option(socket, TCP_USER_TIMEOUT, static_cast<int>(kHalfOpenLimit.count()));
}

struct Resolved {
  boost::system::error_code error;
  tcp::resolver::results_type endpoints;
};

/// Within kTcpPatience, though the system's own look-up knows no end.
Resolved resolve(const TcpAddress& address) {
  const auto resolved = finish_within(kTcpPatience, [address] {
    boost::asio::io_context io;
    Resolved result;
    result.endpoints = tcp::resolver(io).resolve(address.host, address.port, result.error);
    return result;
  });
  return resolved.value_or(Resolved{boost::asio::error::timed_out, {}});
}

/// Connects within kTcpPatience; the error of the last address that was tried.
boost::system::error_code connect(AsioStream<tcp::socket>& stream, const TcpAddress& address) {
  const auto [error, endpoints] = resolve(address);
  if (error) {
    return error;
  }
  return connect_within(stream, kTcpPatience, [&stream, &found = endpoints](auto handler) {
    boost::asio::async_connect(stream.stream(), found, handler);
  });
}

}  // namespace

std::unique_ptr<ByteStream> open_tcp_stream(const std::string& address) {
  const auto parsed = parse_tcp_address(address);
  if (!parsed) {
    fail_to_reach_host(address, "it is not of the form tcp://host:port");
  }
  auto stream = std::make_unique<AsioStream<tcp::socket>>(address);
  if (const auto error = connect(*stream, *parsed)) {
    fail_to_reach_host(address, error.message());
  }
  stream->stream().set_option(tcp::no_delay(true));
  notice_half_open(stream->stream());
  return stream;
}

}  // namespace echomap::transport

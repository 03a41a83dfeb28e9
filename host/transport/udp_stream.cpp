// SPDX-License-Identifier: MIT
#include "host/transport/udp_stream.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include <boost/asio/error.hpp>
#include <boost/asio/ip/udp.hpp>

#include "host/transport/tcp_address.hpp"
#include "host/transport/transport_error.hpp"

namespace echomap::transport {
namespace {

using boost::asio::ip::udp;

/// So many empty datagrams at once: who sends no end of them cannot keep a read from returning.
constexpr int kMaxPassedOver = 64;

[[noreturn]] void fail_to_listen(const std::string& address, const std::string& reason) {
  throw TransportError("cannot listen on " + address,
                       reason,
                       "name an address of this machine and a free port, as udp:127.0.0.1:7001");
}

class UdpStream final : public ByteStream {
 public:
  UdpStream(std::string name, const udp::endpoint& endpoint)
      : name_(std::move(name)), socket_(io_, endpoint) {
    socket_.non_blocking(true);
  }

  std::size_t read_some(std::span<std::uint8_t> into, std::chrono::microseconds wait) override {
    if (begin_ == end_) {
      receive(wait);
    }
    const std::size_t count = std::min(into.size(), end_ - begin_);
    std::copy_n(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_), count, into.begin());
    begin_ += count;
    return count;
  }
  void write(std::span<const std::uint8_t> /*bytes*/) override {}
  StreamStatus status() const override { return StreamStatus::kOpen; }
  std::string close_reason() const override { return {}; }
  std::string name() const override { return name_; }

 private:
  void receive(std::chrono::microseconds wait) {
    if (!take_next() && wait.count() > 0) {
      wait_for_datagram(wait);
      take_next();
    }
  }
  /// The next datagram that holds something; false where none is there.
  bool take_next() {
    for (int i = 0; i < kMaxPassedOver; ++i) {
      boost::system::error_code error;  // Of a datagram that came to nobody, too.
      begin_ = 0;
      end_ = socket_.receive(boost::asio::buffer(buffer_.data(), buffer_.size() - 1), 0, error);
      if (end_ > 0) {
        end_line();
        return true;
      }
      if (error == boost::asio::error::would_block) {
        return false;
      }
    }
    return false;
  }
  void end_line() {
    if (buffer_[end_ - 1] != '\n') {
      buffer_[end_++] = '\n';
    }
  }
  void wait_for_datagram(std::chrono::microseconds wait) {
    socket_.async_wait(udp::socket::wait_read, [](const boost::system::error_code& /*error*/) {});
    io_.restart();
    io_.run_for(wait);
    socket_.cancel();
    io_.restart();
    io_.poll();
  }

  std::string name_;
  boost::asio::io_context io_{1};
  udp::socket socket_;
  std::array<std::uint8_t, 4097> buffer_{};
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

}  // namespace

std::unique_ptr<ByteStream> open_udp_stream(const std::string& address) {
  constexpr std::string_view kScheme = "udp://";
  const auto parsed = address.starts_with(kScheme)
                          ? parse_tcp_address("tcp://" + address.substr(kScheme.size()))
                          : std::nullopt;
  if (!parsed) {
    fail_to_listen(address, "it is not of the form udp://host:port");
  }
  boost::system::error_code error;
  const auto number = boost::asio::ip::make_address(
      parsed->host == "localhost" ? "127.0.0.1" : parsed->host, error);
  if (error) {
    fail_to_listen(address, "'" + parsed->host + "' is not an address in numbers");
  }
  const auto port = static_cast<std::uint16_t>(std::atoi(parsed->port.c_str()));
  try {
    return std::make_unique<UdpStream>(address, udp::endpoint(number, port));
  } catch (const boost::system::system_error& taken) {
    fail_to_listen(address, taken.code().message());
  }
}

}  // namespace echomap::transport

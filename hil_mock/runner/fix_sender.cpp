// SPDX-License-Identifier: MIT
#include "hil_mock/runner/fix_sender.hpp"

#include <charconv>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <netinet/in.h>
#include <sys/socket.h>

#include "hil_mock/runner/descriptor.hpp"
#include "hil_mock/runner/tcp_endpoint.hpp"

namespace echomap::runner {
namespace {

class UdpFixSender final : public FixSender {
 public:
  explicit UdpFixSender(std::uint16_t port)
      : socket_(::socket(AF_INET, SOCK_DGRAM | kSocketFlags, 0), "socket") {
    receiver_.sin_family = AF_INET;
    receiver_.sin_port = htons(port);
    receiver_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  }

  void send(const std::string& line) override {
    [[maybe_unused]] const ssize_t sent = ::sendto(socket_.number(),
                                                   line.data(),
                                                   line.size(),
                                                   MSG_NOSIGNAL,
                                                   reinterpret_cast<const sockaddr*>(&receiver_),
                                                   sizeof receiver_);
  }

 private:
  Descriptor socket_;
  sockaddr_in receiver_{};
};

class TcpFixSender final : public FixSender {
 public:
  explicit TcpFixSender(std::uint16_t port) : endpoint_(port, WhenUnread::kDrop) {}

  void send(const std::string& line) override {
    endpoint_.receive();  // Takes a new client in.
    const std::string text = line + "\n";
    endpoint_.send(std::vector<std::uint8_t>(text.begin(), text.end()));
  }

 private:
  TcpEndpoint endpoint_;
};

std::optional<std::uint16_t> port_in(std::string_view text) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  return is_whole ? std::optional(port) : std::nullopt;
}

}  // namespace

std::unique_ptr<FixSender> make_fix_sender(const std::string& address) {
  constexpr std::size_t kKindLength = 4;
  const std::string kind = address.substr(0, kKindLength);
  const auto port = address.size() > kKindLength
                        ? port_in(std::string_view(address).substr(kKindLength))
                        : std::nullopt;
  if (port && kind == "udp:" && *port != 0) {
    return std::make_unique<UdpFixSender>(*port);
  }
  if (port && kind == "tcp:") {
    return std::make_unique<TcpFixSender>(*port);
  }
  throw std::invalid_argument("'" + address + "': expected udp:PORT or tcp:PORT");
}

}  // namespace echomap::runner

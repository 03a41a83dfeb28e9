// SPDX-License-Identifier: MIT
#include "hil_mock/runner/tcp_endpoint.hpp"

#include <array>
#include <cerrno>
#include <unistd.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

namespace echomap::runner {

TcpEndpoint::TcpEndpoint(std::uint16_t port, WhenUnread when_unread)
    : when_unread_(when_unread),
      outgoing_(when_unread),
      listener_(::socket(AF_INET, SOCK_STREAM | kSocketFlags, 0), "socket") {
  const std::string tried = "cannot listen on 127.0.0.1:" + std::to_string(port);
  const int on = 1;
  check_call(::setsockopt(listener_.number(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on), tried);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* generic = reinterpret_cast<sockaddr*>(&address);
  check_call(::bind(listener_.number(), generic, size), tried);
  check_call(::listen(listener_.number(), 1), tried);
  check_call(::getsockname(listener_.number(), generic, &size), tried);
  port_ = ntohs(address.sin_port);
}

std::vector<std::uint8_t> TcpEndpoint::receive() {
  if (!client_.is_open()) {
    accept_client();
    return {};
  }
  std::vector<std::uint8_t> bytes;
  std::array<std::uint8_t, 4096> chunk{};
  ssize_t count = 0;
  while ((count = ::read(client_.number(), chunk.data(), chunk.size())) > 0) {
    bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + count);
  }
  if (count == 0 || (errno != EAGAIN && errno != EINTR)) {
    client_.close();
    outgoing_.discard();
  }
  return bytes;
}

void TcpEndpoint::send(std::span<const std::uint8_t> bytes) {
  outgoing_.push(bytes);
  if (client_.is_open()) {
    outgoing_.write_to(client_.number());
  } else if (when_unread_ == WhenUnread::kDrop) {
    outgoing_.discard();
  }
}

int TcpEndpoint::descriptor() const {
  return client_.is_open() ? client_.number() : listener_.number();
}

void TcpEndpoint::accept_client() {
  const int accepted = ::accept4(listener_.number(), nullptr, nullptr, kSocketFlags);
  if (accepted < 0) {
    return;
  }
  client_ = Descriptor(accepted, "accept");
  const int on = 1;
  check_call(::setsockopt(accepted, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on), "TCP_NODELAY");
}

}  // namespace echomap::runner

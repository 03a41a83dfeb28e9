// SPDX-License-Identifier: MIT
#include "hil_mock/runner/tcp_endpoint.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <unistd.h>
#include <utility>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/socket.h>

namespace echomap::runner {
namespace {

constexpr int kBacklog = 4;

}  // namespace

TcpEndpoint::TcpEndpoint(std::uint16_t port, WhenUnread when_unread)
    : when_unread_(when_unread),
      ready_(::epoll_create1(EPOLL_CLOEXEC), "epoll_create1"),
      listener_(::socket(AF_INET, SOCK_STREAM | kSocketFlags, 0), "socket"),
      before_first_(when_unread) {
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
  check_call(::listen(listener_.number(), kBacklog), tried);
  check_call(::getsockname(listener_.number(), generic, &size), tried);
  port_ = ntohs(address.sin_port);
  watch(listener_.number());
}

std::vector<std::uint8_t> TcpEndpoint::receive() {
  accept_clients();
  std::vector<std::uint8_t> bytes;
  std::erase_if(clients_, [&](Client& client) {
    const bool has_gone = !read_from(client, bytes);
    if (has_gone) {
      client.outgoing.discard();
      dropped_ += client.outgoing.dropped();
    }
    return has_gone;
  });
  return bytes;
}

void TcpEndpoint::send(std::span<const std::uint8_t> bytes) {
  for (Client& client : clients_) {
    client.outgoing.push(bytes);
    client.outgoing.write_to(client.socket.number());
  }
  if (clients_.empty() && when_unread_ == WhenUnread::kKeep) {
    before_first_.push(bytes);
  } else if (clients_.empty()) {
    dropped_ += bytes.size();
  }
}

bool TcpEndpoint::is_sending() const {
  return std::ranges::any_of(clients_,
                             [](const Client& client) { return !client.outgoing.empty(); });
}

std::uint64_t TcpEndpoint::dropped_bytes() const {
  std::uint64_t dropped = dropped_;
  for (const Client& client : clients_) {
    dropped += client.outgoing.dropped();
  }
  return dropped;
}

void TcpEndpoint::accept_clients() {
  int accepted = 0;
  while ((accepted = ::accept4(listener_.number(), nullptr, nullptr, kSocketFlags)) >= 0) {
    Descriptor socket(accepted, "accept");
    const int on = 1;
    check_call(::setsockopt(accepted, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on), "TCP_NODELAY");
    watch(accepted);
    clients_.push_back(
        {std::move(socket), std::exchange(before_first_, OutgoingBytes(when_unread_))});
  }
}

void TcpEndpoint::watch(int descriptor) {
  epoll_event readable{};
  readable.events = EPOLLIN;
  check_call(::epoll_ctl(ready_.number(), EPOLL_CTL_ADD, descriptor, &readable), "epoll_ctl");
}

bool TcpEndpoint::read_from(const Client& client, std::vector<std::uint8_t>& bytes) {
  std::array<std::uint8_t, 4096> chunk{};
  ssize_t count = 0;
  while ((count = ::read(client.socket.number(), chunk.data(), chunk.size())) > 0) {
    bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + count);
  }
  return count < 0 && (errno == EAGAIN || errno == EINTR);
}

}  // namespace echomap::runner

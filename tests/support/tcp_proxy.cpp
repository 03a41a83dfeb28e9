// SPDX-License-Identifier: MIT
#include "tests/support/tcp_proxy.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <list>
#include <mutex>
#include <optional>
#include <poll.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include "host/transport/file_descriptor.hpp"
#include "tests/support/proxied_connection.hpp"

namespace echomap::tests {
namespace {

using Clock = std::chrono::steady_clock;
using transport::FileDescriptor;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

void set_no_delay(int socket) {
  const int on = 1;
  ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

/// The other end gets a reset when the socket is closed, not an end.
void reset_at_close(int socket) {
  const linger at_once{1, 0};
  ::setsockopt(socket, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
}

}  // namespace

/// Lives in the proxy's thread but for its constructor, destructor and orders.
class TcpProxy::Impl {
 public:
  enum class Passing : std::uint8_t { kOpen, kStalled, kCut };

  explicit Impl(std::uint16_t target_port)
      : target_port_(target_port),
        listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)),
        wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    sockaddr_in address = loopback(0);
    socklen_t size = sizeof address;
    if (::bind(listener_.get(), reinterpret_cast<sockaddr*>(&address), size) != 0 ||
        ::listen(listener_.get(), 256) != 0 ||
        ::getsockname(listener_.get(), reinterpret_cast<sockaddr*>(&address), &size) != 0) {
      fail("no port for a TCP proxy");
    }
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { run(); });
  }
  ~Impl() {
    is_ended_ = true;
    wake();
    thread_.join();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  std::uint16_t port() const { return port_; }
  std::size_t passed_bytes() const { return passed_bytes_; }
  std::size_t connections_made() const { return connections_made_; }
  void set_delay(std::chrono::milliseconds delay) { delay_ms_ = delay.count(); }
  /// Returns when no byte is passed on in the former way any more.
  void set(Passing passing) {
    passing_ = passing;
    wake();
    for (Passing now = applied_; now != passing; now = applied_) {
      applied_.wait(now);
    }
  }

 private:
  void wake() const {
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = ::write(wake_.get(), &one, sizeof one);
  }

  void run() {
    while (!is_ended_) {
      wait();
      applied_ = passing_.load();
      applied_.notify_all();
      accept();
      if (applied_ == Passing::kCut) {
        reset_all();
      } else if (applied_ == Passing::kOpen) {
        pass();
      }
    }
  }

  /// Until something can be done: bytes, room for bytes, a connection, an order, or a chunk is due.
  void wait() {
    std::vector<pollfd> waited{{wake_.get(), POLLIN, 0}, {listener_.get(), POLLIN, 0}};
    std::optional<Clock::time_point> next;
    if (passing_ == Passing::kOpen) {
      for (const ProxiedConnection& connection : connections_) {
        for (const ProxyPipe& pipe : connection.pipes) {
          if (pipe.wants_bytes()) {
            waited.push_back({pipe.from(), POLLIN, 0});
          }
          const auto due = pipe.due();
          if (due && *due <= Clock::now()) {
            waited.push_back({pipe.to(), POLLOUT, 0});
          } else if (due && (!next || *due < *next)) {
            next = due;
          }
        }
      }
    }
    ::poll(waited.data(), waited.size(), next ? until_ms(*next) : -1);
    std::uint64_t count = 0;
    [[maybe_unused]] const ssize_t read = ::read(wake_.get(), &count, sizeof count);
  }

  static int until_ms(Clock::time_point time) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(time - Clock::now());
    return static_cast<int>(std::max<std::int64_t>(0, left.count()));
  }

  void accept() {
    for (;;) {
      const int client = ::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC);
      if (client < 0) {
        return;
      }
      if (applied_ == Passing::kCut) {
        reset_at_close(client);
        ::close(client);
      } else {
        connect_through(client);
      }
    }
  }

  void connect_through(int client) {
    const int target = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    connections_.emplace_back(client, target);
    const sockaddr_in address = loopback(target_port_);
    if (::connect(target, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
      reset_at_close(client);
      connections_.pop_back();
      return;
    }
    set_no_delay(client);
    set_no_delay(target);
    ++connections_made_;
  }

  void reset_all() {
    for (const ProxiedConnection& connection : connections_) {
      reset_at_close(connection.client.get());
      reset_at_close(connection.target.get());
    }
    connections_.clear();
  }

  void pass() {
    for (ProxiedConnection& connection : connections_) {
      for (ProxyPipe& pipe : connection.pipes) {
        if (pipe.wants_bytes()) {
          pipe.read(delay_ms_);
        }
        passed_bytes_ += pipe.write();
      }
    }
    connections_.remove_if([](const ProxiedConnection& connection) {
      return std::ranges::any_of(connection.pipes, &ProxyPipe::is_done);
    });
  }

  std::uint16_t target_port_;
  std::uint16_t port_ = 0;
  FileDescriptor listener_;
  FileDescriptor wake_;
  std::list<ProxiedConnection> connections_;
  std::atomic<std::int64_t> delay_ms_ = 0;
  std::atomic<Passing> passing_ = Passing::kOpen;
  /// What the thread goes by.
  std::atomic<Passing> applied_ = Passing::kOpen;
  std::atomic<bool> is_ended_ = false;
  std::atomic<std::size_t> passed_bytes_ = 0;
  std::atomic<std::size_t> connections_made_ = 0;
  std::thread thread_;
};

TcpProxy::TcpProxy(std::uint16_t target_port) : impl_(std::make_unique<Impl>(target_port)) {}

TcpProxy::~TcpProxy() = default;

std::uint16_t TcpProxy::port() const { return impl_->port(); }

void TcpProxy::set_delay(std::chrono::milliseconds delay) { impl_->set_delay(delay); }

void TcpProxy::stall() { impl_->set(Impl::Passing::kStalled); }

void TcpProxy::cut() { impl_->set(Impl::Passing::kCut); }

void TcpProxy::resume() { impl_->set(Impl::Passing::kOpen); }

std::size_t TcpProxy::passed_bytes() const { return impl_->passed_bytes(); }

std::size_t TcpProxy::connections() const { return impl_->connections_made(); }

}  // namespace echomap::tests

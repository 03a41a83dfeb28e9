// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/clock_server.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <unistd.h>

#include <sys/socket.h>
#include <sys/un.h>

namespace echomap::ev3 {
namespace {

constexpr std::size_t kTimeBytes = 8;
constexpr unsigned kByteBits = 8;
/// How often a waiting world looks about.
constexpr std::chrono::milliseconds kLook{20};

using TimeBytes = std::array<std::uint8_t, kTimeBytes>;

TimeBytes bytes_of(std::uint64_t time_us) {
  TimeBytes bytes{};
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(time_us);
    time_us >>= kByteBits;
  }
  return bytes;
}

std::uint64_t time_of(const TimeBytes& bytes) {
  std::uint64_t time_us = 0;
  for (std::size_t i = kTimeBytes; i-- > 0;) {
    time_us = time_us << kByteBits | bytes.at(i);
  }
  return time_us;
}

/// Whoever has gone will be found gone at the next read.
void tell_time(const runner::Descriptor& socket, std::uint64_t now_us) {
  const TimeBytes bytes = bytes_of(now_us);
  static_cast<void>(::send(socket.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL));
}

}  // namespace

ClockServer::ClockServer(const std::filesystem::path& socket)
    : listener_(::socket(AF_UNIX, SOCK_STREAM | runner::kSocketFlags, 0), "clock socket") {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = socket.string();
  if (name.size() >= sizeof address.sun_path) {
    throw std::runtime_error("clock socket: its name is too long: " + name);
  }
  std::copy(name.begin(), name.end(), std::begin(address.sun_path));
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the interface of the kernel
  const auto* generic = reinterpret_cast<const sockaddr*>(&address);
  runner::check_call(::bind(listener_.number(), generic, sizeof address), name);
  runner::check_call(::listen(listener_.number(), SOMAXCONN), name);
}

void ClockServer::wait_until_all_sleep(std::uint64_t now_us,
                                       std::chrono::milliseconds limit,
                                       const std::function<void()>& on_wait) {
  const auto end = std::chrono::steady_clock::now() + limit;
  for (;;) {
    hear_all();
    accept_all(now_us);
    if (!has_busy_one()) {
      return;
    }
    on_wait();
    if (std::chrono::steady_clock::now() >= end) {
      for (Client& client : clients_) {
        client.is_hung = client.is_hung || !client.is_asleep;
      }
      return;
    }
    poll_all(kLook);
  }
}

std::optional<std::uint64_t> ClockServer::next_wake_us() const {
  std::optional<std::uint64_t> next_us;
  for (const Client& client : clients_) {
    if (client.is_asleep && (!next_us || client.until_us < *next_us)) {
      next_us = client.until_us;
    }
  }
  return next_us;
}

void ClockServer::wake(std::uint64_t now_us, bool early) {
  for (Client& client : clients_) {
    const bool is_last = &client == &clients_.back();
    if (client.is_asleep && (client.until_us <= now_us || (early && is_last))) {
      client.is_asleep = false;
      tell_time(client.socket, now_us);
    }
  }
}

void ClockServer::wait_for_connection(std::uint64_t now_us) {
  poll_all(kLook);
  accept_all(now_us);
}

void ClockServer::accept_all(std::uint64_t now_us) {
  for (;;) {
    const int number = ::accept4(listener_.number(), nullptr, nullptr, runner::kSocketFlags);
    if (number < 0) {
      return;
    }
    clients_.push_back({runner::Descriptor(number, "clock socket"), false, false, 0});
    ++connections_;
    tell_time(clients_.back().socket, now_us);
  }
}

void ClockServer::hear_all() {
  std::erase_if(clients_, [](Client& client) {
    TimeBytes bytes{};
    const auto count = ::recv(client.socket.number(), bytes.data(), bytes.size(), 0);
    if (count < 0) {
      return errno != EAGAIN && errno != EINTR;
    }
    if (count != static_cast<ssize_t>(kTimeBytes)) {
      return true;
    }
    client.until_us = time_of(bytes);
    client.is_asleep = true;
    client.is_hung = false;
    return false;
  });
}

bool ClockServer::has_busy_one() const {
  return std::any_of(clients_.begin(), clients_.end(), [](const Client& client) {
    return !client.is_asleep && !client.is_hung;
  });
}

void ClockServer::poll_all(std::chrono::milliseconds most) const {
  std::vector<pollfd> polled{{listener_.number(), POLLIN, 0}};
  for (const Client& client : clients_) {
    polled.push_back({client.socket.number(), POLLIN, 0});
  }
  ::poll(polled.data(), polled.size(), static_cast<int>(most.count()));
}

}  // namespace echomap::ev3

// SPDX-License-Identifier: MIT
#include "host/live_page/connection_list.hpp"

#include <algorithm>
#include <vector>

#include <sys/resource.h>

namespace echomap::live_page {
namespace {

constexpr std::size_t kMaxConnections = 1200;
constexpr std::size_t kMinConnections = 16;
constexpr std::size_t kFilesOfTheRun = 200;  ///< Descriptors that are left to it.

}  // namespace

ConnectionList::Place ConnectionList::add(const std::weak_ptr<Connection>& connection) {
  const std::size_t number = next_number_++;
  connections_[number] = connection;
  return {nullptr, [this, number](void*) { connections_.erase(number); }};
}

void ConnectionList::close_blocked(std::chrono::steady_clock::duration patience) {
  const auto latest = std::chrono::steady_clock::now() - patience;
  std::vector<std::shared_ptr<Connection>> blocked;
  for (const auto& [number, place] : connections_) {
    auto connection = place.lock();
    if (connection && connection->blocked_since() < latest) {
      blocked.push_back(std::move(connection));
    }
  }
  for (const auto& connection : blocked) {
    connection->close();
  }
}

void ConnectionList::close_all() {
  std::vector<std::shared_ptr<Connection>> open;
  for (const auto& [number, place] : connections_) {
    if (auto connection = place.lock()) {
      open.push_back(std::move(connection));
    }
  }
  for (const auto& connection : open) {
    connection->close();
  }
}

std::size_t max_connections_of_this_process() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
    return kMaxConnections;
  }
  const auto files = static_cast<std::size_t>(limit.rlim_cur);
  const std::size_t left = files > kFilesOfTheRun ? files - kFilesOfTheRun : 0;
  return std::clamp(left, kMinConnections, kMaxConnections);
}

}  // namespace echomap::live_page

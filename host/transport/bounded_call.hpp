// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <future>
#include <optional>
#include <thread>
#include <utility>

namespace echomap::transport {

/// What `work` returns, if it does within `limit`. Work that nobody can cancel, as looking a name
/// up, is left to itself after that: it must not refer to anything that ends before the program.
template <class Work>
auto finish_within(std::chrono::milliseconds limit, Work work) -> std::optional<decltype(work())> {
  std::packaged_task<decltype(work())()> task(std::move(work));
  auto result = task.get_future();
  std::thread(std::move(task)).detach();
  return result.wait_for(limit) == std::future_status::ready ? std::optional(result.get())
                                                             : std::nullopt;
}

}  // namespace echomap::transport

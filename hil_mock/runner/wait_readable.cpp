// SPDX-License-Identifier: MIT
#include "hil_mock/runner/wait_readable.hpp"

#include <poll.h>
#include <vector>

namespace echomap::runner {

void wait_readable(std::span<const Awaited> awaited, std::chrono::microseconds most) {
  std::vector<pollfd> watched;
  for (const Awaited& one : awaited) {
    const auto wanted = static_cast<short>(one.endpoint->is_sending() ? POLLIN | POLLOUT : POLLIN);
    watched.push_back({one.endpoint->descriptor(), wanted, 0});
    watched.push_back({one.other, POLLIN, 0});
  }
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(most);
  const timespec limit{seconds.count(), std::chrono::nanoseconds(most - seconds).count()};
  ::ppoll(watched.data(), watched.size(), &limit, nullptr);
}

void wait_readable(const ByteEndpoint& endpoint, int other, std::chrono::microseconds most) {
  const Awaited one{&endpoint, other};
  wait_readable(std::span(&one, 1), most);
}

}  // namespace echomap::runner

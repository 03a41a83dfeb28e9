// SPDX-License-Identifier: MIT
#include "hil_mock/runner/wait_readable.hpp"

#include <array>
#include <poll.h>

namespace echomap::runner {

void wait_readable(const ByteEndpoint& endpoint, int other, std::chrono::microseconds most) {
  const auto wanted = static_cast<short>(endpoint.is_sending() ? POLLIN | POLLOUT : POLLIN);
  std::array<pollfd, 2> watched{{{endpoint.descriptor(), wanted, 0}, {other, POLLIN, 0}}};
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(most);
  const timespec limit{seconds.count(), std::chrono::nanoseconds(most - seconds).count()};
  ::ppoll(watched.data(), watched.size(), &limit, nullptr);
}

}  // namespace echomap::runner

// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <span>

#include "hil_mock/runner/byte_endpoint.hpp"

namespace echomap::runner {

/// What is waited for: an endpoint, and a descriptor beside it (negative for none).
struct Awaited {
  const ByteEndpoint* endpoint = nullptr;
  int other = -1;
};

/// Waits until one of them is readable, until an endpoint can take more of what is on its way,
/// until a signal comes or until `most` is over.
void wait_readable(std::span<const Awaited> awaited, std::chrono::microseconds most);

/// The same for one.
void wait_readable(const ByteEndpoint& endpoint, int other, std::chrono::microseconds most);

}  // namespace echomap::runner

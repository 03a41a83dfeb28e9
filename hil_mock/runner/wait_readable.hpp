// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

#include "hil_mock/runner/byte_endpoint.hpp"

namespace echomap::runner {

/// Waits until the endpoint or `other` (negative for none) is readable, until the endpoint can
/// take more of what is on its way, until a signal comes or until `most` is over.
void wait_readable(const ByteEndpoint& endpoint, int other, std::chrono::microseconds most);

}  // namespace echomap::runner

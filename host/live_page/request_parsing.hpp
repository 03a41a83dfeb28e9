// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "host/live_page/web_request.hpp"
#include "host/live_page/web_response.hpp"

namespace echomap::live_page {

/// Together they are what a request may have, 16 KiB.
inline constexpr std::uint32_t kMaxHeaderBytes = 12U << 10U;
inline constexpr std::uint64_t kMaxBodyBytes = 4U << 10U;

/// One whole request, as the server reads it from a socket: what it says, how it is refused, or
/// nothing where bytes are missing.
std::optional<std::variant<WebRequest, WebResponse>> parse_request(std::string_view bytes);

}  // namespace echomap::live_page

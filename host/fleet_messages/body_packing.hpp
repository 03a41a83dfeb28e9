// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace echomap::fleet_messages {

/// One zstd frame (RFC 8878) that says its size.
std::string pack(std::string_view bytes);

/// What `pack` packed; empty where the bytes are not one whole frame that says its size, or where
/// it has more than `max_bytes`. Memory is what the frame says, bounded by `max_bytes`.
std::optional<std::string> unpack(std::string_view packed, std::size_t max_bytes);

}  // namespace echomap::fleet_messages

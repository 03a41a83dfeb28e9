// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace echomap::fleet_messages {

/// Compresses bytes to one zstd frame (RFC 8878) that states its content size.
std::string pack(std::string_view bytes);

/// Decompresses what `pack` returned. Empty where the bytes are not one whole frame that states its
/// content size, or where that exceeds `max_bytes`. Allocates the stated size, at most `max_bytes`.
std::optional<std::string> unpack(std::string_view packed, std::size_t max_bytes);

}  // namespace echomap::fleet_messages

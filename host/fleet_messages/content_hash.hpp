// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace echomap::fleet_messages {

/// The name of an object: the first 128 bits of SHA-256 (FIPS 180-4) of its bytes. To find other
/// bytes of a given name takes 2^128 tries.
struct ContentHash {
  std::array<std::uint8_t, 16> bytes{};
  auto operator<=>(const ContentHash&) const = default;
};

/// Hash of any bytes.
ContentHash content_hash(std::string_view bytes);

/// Hash of a set of objects: of their names in ascending order, whatever their order in `objects`.
ContentHash set_hash(std::vector<ContentHash> objects);

/// The hash as 32 lower-case hexadecimal digits.
std::string hex(const ContentHash& hash);
/// Parses what `hex` returns; empty for any other text.
std::optional<ContentHash> parse_hash(std::string_view text);

/// Hash function for unordered containers: a content hash is as good as random already.
struct ContentHashBucket {
  std::size_t operator()(const ContentHash& hash) const;
};

}  // namespace echomap::fleet_messages

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "host/mcap/records.hpp"

namespace echomap::mcap {

/// How the records of a chunk are compressed.
enum class Compression : std::uint8_t { kNone, kZstd, kLz4 };

/// Name of a compression in a file: "", "zstd" or "lz4".
std::string name_of(Compression compression);

/// The compressed form of `bytes`: one zstd frame or one LZ4 frame. `level` is that of zstd; 1 is
/// the fastest, 19 the smallest. The same bytes give the same result.
Bytes compress(std::span<const std::uint8_t> bytes, Compression compression, int level);

/// The original of what was compressed under `name`. Throws RecordError for a name that is none of
/// the three, for bytes that are damaged and where the original has not exactly `original_bytes`.
/// Memory grows with what is really there, not with what `original_bytes` claims.
Bytes decompress(std::span<const std::uint8_t> compressed,
                 const std::string& name,
                 std::uint64_t original_bytes);

}  // namespace echomap::mcap

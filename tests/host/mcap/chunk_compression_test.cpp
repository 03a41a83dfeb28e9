// SPDX-License-Identifier: MIT
#include "host/mcap/chunk_compression.hpp"

#include <cstdint>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/mcap/record_reader.hpp"
#include "tests/host/mcap/small_file.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::mcap {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Half of it random, half of it zeros.
Bytes half_random_bytes(std::size_t count) {
  std::mt19937 random(1);
  Bytes bytes(count);
  for (std::size_t i = 0; i < count / 2; ++i) {
    bytes[i] = static_cast<std::uint8_t>(random());
  }
  return bytes;
}

std::string decompression_error(const Bytes& bytes, const std::string& name, std::uint64_t size) {
  return tests::thrown_text<RecordError>([&] { decompress(bytes, name, size); });
}

TEST(ChunkCompression, GivesTheOriginalBack) {
  for (const auto compression : {Compression::kNone, Compression::kZstd, Compression::kLz4}) {
    for (const std::size_t count : {0U, 1U, 65535U, 65536U, 65537U, 3000000U}) {
      const Bytes original = half_random_bytes(count);
      const Bytes compressed = compress(original, compression, 3);
      EXPECT_EQ(decompress(compressed, name_of(compression), count), original);
    }
  }
}

TEST(ChunkCompression, MakesTheSameBytesOfTheSameBytes) {
  const Bytes original = half_random_bytes(100000);
  EXPECT_EQ(compress(original, Compression::kZstd, 3), compress(original, Compression::kZstd, 3));
  EXPECT_EQ(compress(original, Compression::kLz4, 3), compress(original, Compression::kLz4, 3));
}

TEST(ChunkCompression, TakesFramesOneAfterTheOther) {
  for (const auto compression : {Compression::kZstd, Compression::kLz4}) {
    Bytes two = compress(bytes_of("first, "), compression, 3);
    const Bytes second = compress(bytes_of("second"), compression, 3);
    two.insert(two.end(), second.begin(), second.end());
    EXPECT_EQ(decompress(two, name_of(compression), 13), bytes_of("first, second"));
  }
}

TEST(ChunkCompression, RefusesAnotherSizeThanDeclared) {
  const Bytes original = half_random_bytes(1000);
  for (const auto compression : {Compression::kNone, Compression::kZstd, Compression::kLz4}) {
    const Bytes compressed = compress(original, compression, 3);
    const std::string name = name_of(compression);
    for (const std::uint64_t size : {std::uint64_t{0}, std::uint64_t{999}, std::uint64_t{1001}}) {
      EXPECT_THAT(decompression_error(compressed, name, size),
                  HasSubstr("are not the " + std::to_string(size) + " bytes that it declares"));
    }
  }
}

TEST(ChunkCompression, RefusesFramesThatAreCutOffOrGarbage) {
  for (const auto compression : {Compression::kZstd, Compression::kLz4}) {
    const std::string name = name_of(compression);
    Bytes compressed = compress(half_random_bytes(1000), compression, 3);
    compressed.pop_back();
    EXPECT_THAT(decompression_error(compressed, name, 1000), HasSubstr("bytes that it declares"));
    EXPECT_THAT(decompression_error({}, name, 1000), HasSubstr("bytes that it declares"));
    EXPECT_THAT(decompression_error(Bytes(100, 'x'), name, 1000), StartsWith(name + ": "));
  }
}

TEST(ChunkCompression, NamesOnlyWhatATerminalCanShow) {
  EXPECT_THAT(decompression_error({}, "gz\x1b[2J", 0), HasSubstr("by 'gz?[2J'"));
  EXPECT_LT(decompression_error({}, std::string(10000, 'x'), 0).size(), 200U);
}

}  // namespace
}  // namespace echomap::mcap

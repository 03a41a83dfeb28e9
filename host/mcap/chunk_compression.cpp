// SPDX-License-Identifier: MIT
#include "host/mcap/chunk_compression.hpp"

#include <algorithm>
#include <cstddef>
#include <lz4frame.h>
#include <memory>
#include <new>
#include <stdexcept>
#include <zstd.h>

#include "host/mcap/record_reader.hpp"

namespace echomap::mcap {

namespace {

/// What one call of a decoder did.
struct DecoderStep {
  std::size_t read_bytes = 0;
  std::size_t written_bytes = 0;
  bool is_frame_end = false;
};

Bytes compress_zstd(std::span<const std::uint8_t> bytes, int level) {
  Bytes compressed(ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compress(compressed.data(), compressed.size(), bytes.data(), bytes.size(), level);
  if (ZSTD_isError(size) != 0) {
    throw std::runtime_error(std::string("cannot compress a chunk: ") + ZSTD_getErrorName(size));
  }
  compressed.resize(size);
  return compressed;
}

Bytes compress_lz4(std::span<const std::uint8_t> bytes) {
  Bytes compressed(LZ4F_compressFrameBound(bytes.size(), nullptr));
  const std::size_t size =
      LZ4F_compressFrame(compressed.data(), compressed.size(), bytes.data(), bytes.size(), nullptr);
  if (LZ4F_isError(size) != 0U) {
    throw std::runtime_error(std::string("cannot compress a chunk: ") + LZ4F_getErrorName(size));
  }
  compressed.resize(size);
  return compressed;
}

/// Decodes zstd frames step by step.
class ZstdDecoder {
 public:
  ZstdDecoder() : context_(ZSTD_createDCtx(), &ZSTD_freeDCtx) {
    if (context_ == nullptr) {
      throw std::bad_alloc();
    }
  }
  DecoderStep step(std::span<const std::uint8_t> from, std::span<std::uint8_t> to) {
    ZSTD_inBuffer input{from.data(), from.size(), 0};
    ZSTD_outBuffer output{to.data(), to.size(), 0};
    const std::size_t hint = ZSTD_decompressStream(context_.get(), &output, &input);
    if (ZSTD_isError(hint) != 0) {
      throw RecordError(std::string("zstd: ") + ZSTD_getErrorName(hint));
    }
    return {input.pos, output.pos, hint == 0};
  }

 private:
  std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context_;
};

/// The same for LZ4 frames.
class Lz4Decoder {
 public:
  Lz4Decoder() {
    if (LZ4F_isError(LZ4F_createDecompressionContext(&context_, LZ4F_VERSION)) != 0U) {
      throw std::bad_alloc();
    }
  }
  ~Lz4Decoder() { LZ4F_freeDecompressionContext(context_); }
  Lz4Decoder(const Lz4Decoder&) = delete;
  Lz4Decoder& operator=(const Lz4Decoder&) = delete;

  DecoderStep step(std::span<const std::uint8_t> from, std::span<std::uint8_t> to) {
    std::size_t read = from.size();
    std::size_t written = to.size();
    const std::size_t hint =
        LZ4F_decompress(context_, to.data(), &written, from.data(), &read, nullptr);
    if (LZ4F_isError(hint) != 0U) {
      throw RecordError(std::string("lz4: ") + LZ4F_getErrorName(hint));
    }
    return {read, written, hint == 0};
  }

 private:
  LZ4F_dctx* context_ = nullptr;
};

/// Room for the original that is at least doubled, up to one byte more than it is to have: that
/// byte shows whether there is more of it.
void grow_room(Bytes& original, std::size_t used, std::uint64_t original_bytes) {
  constexpr std::uint64_t kFirstBytes = 1U << 16U;
  if (used == original.size() && used <= original_bytes) {
    original.resize(static_cast<std::size_t>(
        std::min(original_bytes + 1, std::max<std::uint64_t>(kFirstBytes, 4 * used))));
  }
}

template <class Decoder>
Bytes decode_frames(std::span<const std::uint8_t> compressed, std::uint64_t original_bytes) {
  Decoder decoder;
  Bytes original;
  std::size_t used = 0;
  bool is_frame_end = compressed.empty();
  while (true) {
    grow_room(original, used, original_bytes);
    if (compressed.empty() && is_frame_end) {
      break;
    }
    const DecoderStep step = decoder.step(compressed, std::span(original).subspan(used));
    compressed = compressed.subspan(step.read_bytes);
    used += step.written_bytes;
    is_frame_end = step.is_frame_end;
    if (used > original_bytes || (step.read_bytes == 0 && step.written_bytes == 0)) {
      break;
    }
  }
  if (used != original_bytes || !is_frame_end || !compressed.empty()) {
    throw RecordError("the records of the chunk are not the " + std::to_string(original_bytes) +
                      " bytes that it declares");
  }
  original.resize(used);
  return original;
}

}  // namespace

std::string name_of(Compression compression) {
  switch (compression) {
    case Compression::kZstd:
      return "zstd";
    case Compression::kLz4:
      return "lz4";
    case Compression::kNone:
      break;
  }
  return "";
}

Bytes compress(std::span<const std::uint8_t> bytes, Compression compression, int level) {
  switch (compression) {
    case Compression::kZstd:
      return compress_zstd(bytes, level);
    case Compression::kLz4:
      return compress_lz4(bytes);
    case Compression::kNone:
      break;
  }
  return {bytes.begin(), bytes.end()};
}

Bytes decompress(std::span<const std::uint8_t> compressed,
                 const std::string& name,
                 std::uint64_t original_bytes) {
  if (name == "zstd") {
    return decode_frames<ZstdDecoder>(compressed, original_bytes);
  }
  if (name == "lz4") {
    return decode_frames<Lz4Decoder>(compressed, original_bytes);
  }
  if (!name.empty()) {
    throw RecordError("the chunk is compressed by '" + printable_name(name) +
                      "'; this reader knows zstd and lz4");
  }
  if (compressed.size() != original_bytes) {
    throw RecordError("the records of the chunk are not the " + std::to_string(original_bytes) +
                      " bytes that it declares");
  }
  return {compressed.begin(), compressed.end()};
}

}  // namespace echomap::mcap

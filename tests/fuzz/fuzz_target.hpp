// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// A decoder under test, whatever runs it: libFuzzer, or replay_main.cpp where there is none.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace echomap::fuzz {

/// One input of a target.
using Input = std::vector<std::uint8_t>;

/// What a target begins from; every target defines it.
std::vector<Input> seeds();

/// Ends the program where a promise does not hold.
inline void require(bool holds, const char* promise) {
  if (!holds) {
    std::fprintf(stderr, "broken promise: %s\n", promise);
    std::abort();
  }
}

/// Takes an input apart from its front; beyond its end there are zeros.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool at_end() const { return bytes_.empty(); }
  std::uint8_t byte() {
    const std::uint8_t first = bytes_.empty() ? 0 : bytes_.front();
    bytes_ = bytes_.subspan(std::min<std::size_t>(1, bytes_.size()));
    return first;
  }
  /// At most `count` bytes: as many as there are.
  std::span<const std::uint8_t> some(std::size_t count) {
    const auto taken = bytes_.first(std::min(count, bytes_.size()));
    bytes_ = bytes_.subspan(taken.size());
    return taken;
  }
  /// Exactly `count` bytes, in a block of their own, so that nothing is read beyond them unseen.
  Input exactly(std::size_t count) {
    const auto taken = some(count);
    Input block(taken.begin(), taken.end());
    block.resize(count);
    return block;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

/// The bytes of a text.
inline Input input_of(std::string_view text) { return {text.begin(), text.end()}; }

/// A text with a byte before it, which says what kind of text it is.
inline Input input_of(std::uint8_t kind, std::string_view text) {
  Input input{kind};
  input.insert(input.end(), text.begin(), text.end());
  return input;
}

/// The text of an input.
inline std::string text_of(std::span<const std::uint8_t> bytes) {
  return {bytes.begin(), bytes.end()};
}

}  // namespace echomap::fuzz

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace echomap::tests {

/// Six bits of a letter of base64.
inline std::uint32_t base64_value(char letter) {
  if (letter >= 'A' && letter <= 'Z') {
    return static_cast<std::uint32_t>(letter - 'A');
  }
  if (letter >= 'a' && letter <= 'z') {
    return static_cast<std::uint32_t>(letter - 'a' + 26);
  }
  if (letter >= '0' && letter <= '9') {
    return static_cast<std::uint32_t>(letter - '0' + 52);
  }
  if (letter == '+' || letter == '/') {
    return letter == '+' ? 62 : 63;
  }
  throw std::invalid_argument("not a letter of base64");
}

/// The bytes of base64 (RFC 4648), written apart from the encoder, bit by bit.
inline std::vector<std::uint8_t> base64_decoded(std::string_view letters) {
  while (!letters.empty() && letters.back() == '=') {
    letters.remove_suffix(1);
  }
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : letters) {
    bits = bits << 6U | base64_value(letter);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(static_cast<std::uint8_t>(bits >> static_cast<unsigned>(count)));
    }
  }
  return bytes;
}

}  // namespace echomap::tests

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>

namespace echomap::exports {

/// A number in up to nine significant digits: whole multiples of a resolution stay as short as a
/// person would write them.
inline std::string number_text(double value) {
  std::array<char, 32> digits{};
  const int length = std::snprintf(digits.data(), digits.size(), "%.9g", value);
  return {digits.data(), static_cast<std::size_t>(length)};
}

}  // namespace echomap::exports

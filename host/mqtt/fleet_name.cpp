// SPDX-License-Identifier: MIT
#include "host/mqtt/fleet_name.hpp"

#include <algorithm>
#include <cstddef>

namespace echomap::mqtt {
namespace {

constexpr std::size_t kMaxNameLength = 32;

bool is_of_name(char character) {
  return (character >= 'a' && character <= 'z') || (character >= '0' && character <= '9') ||
         character == '_' || character == '-';
}

}  // namespace

bool is_fleet_name(std::string_view name) {
  return !name.empty() && name.size() <= kMaxNameLength && std::ranges::all_of(name, is_of_name);
}

}  // namespace echomap::mqtt

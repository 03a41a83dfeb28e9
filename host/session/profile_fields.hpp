// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "host/files/toml_reader.hpp"

namespace echomap::session {

/// What a field of the wire may hold, in its own unit.
struct Bounds {
  double least;
  double most;
};

/// Whatever a T holds.
template <class T>
constexpr Bounds kAnyOf{std::numeric_limits<T>::min(), std::numeric_limits<T>::max()};

/// The key's number times `scale`, rounded, for a field of the wire; a ConfigError where the board
/// takes no such number.
template <class T>
T field(const files::TomlReader& table,
        std::string_view key,
        double scale = 1.0,
        Bounds bounds = kAnyOf<T>) {
  const double rounded = std::round(table.number(key) * scale);
  if (rounded < bounds.least || rounded > bounds.most) {
    table.fail(key,
               fmt::format("'{}' must lie from {:g} to {:g}: the board takes no other",
                           key,
                           bounds.least / scale,
                           bounds.most / scale));
  }
  return static_cast<T>(rounded);
}

/// The same for a key that may be absent, or 0, for "not watched"; a ConfigError for a number that
/// would become 0 by rounding.
template <class T>
T field_or_zero(const files::TomlReader& table, std::string_view key, double scale, Bounds bounds) {
  if (!table.has(key)) {
    return T{0};
  }
  const T value = field<T>(table, key, scale, bounds);
  if (value == 0 && table.number(key) != 0.0) {
    table.fail(key,
               fmt::format("'{}' must be at least {:g}, or 0 for what is not watched: the board "
                           "counts in such steps",
                           key,
                           1.0 / scale));
  }
  return value;
}

/// The key's number; a ConfigError unless it is positive.
inline double positive(const files::TomlReader& table, std::string_view key) {
  const double value = table.number(key);
  if (value <= 0.0) {
    table.fail(key, "'" + std::string(key) + "' must be greater than zero");
  }
  return value;
}

/// The same; `fallback` where there is no such key.
inline double positive_or(const files::TomlReader& table, std::string_view key, double fallback) {
  return table.has(key) ? positive(table, key) : fallback;
}

}  // namespace echomap::session

// SPDX-License-Identifier: MIT
#include "hil_mock/world/toml_values.hpp"

#include <string>

#include "host/geometry/angle.hpp"

namespace echomap::world {

double positive(const files::TomlReader& table, std::string_view key) {
  const double value = table.number(key);
  if (!(value > 0.0)) {
    table.fail(key, "it must be positive");
  }
  return value;
}

double within(const files::TomlReader& table, std::string_view key, double fallback, double most) {
  const double value = table.number_or(key, fallback);
  if (value < 0.0 || value > most) {
    table.fail(key, "it must be between 0 and " + std::to_string(most));
  }
  return value;
}

double angle(const files::TomlReader& table, std::string_view key, double fallback_rad) {
  return geometry::radians(within(table, key, geometry::degrees(fallback_rad), 180.0));
}

}  // namespace echomap::world

// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "host/files/toml_reader.hpp"

namespace echomap::world {

/// A number above 0. Throws files::ConfigError, as all here, with the place of the key.
double positive(const files::TomlReader& table, std::string_view key);

/// A number from 0 to `most`; `fallback` where the key is absent.
double within(const files::TomlReader& table, std::string_view key, double fallback, double most);

/// An angle from 0 to 180, in the file in degrees.
double angle(const files::TomlReader& table, std::string_view key, double fallback_rad);

}  // namespace echomap::world

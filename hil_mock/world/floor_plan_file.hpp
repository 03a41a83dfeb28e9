// SPDX-License-Identifier: MIT
#pragma once

#include "hil_mock/world/floor_plan.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::world {

/// Reads a room from TOML; docs/guides/simulated_world.md lists the keys. Throws
/// files::ConfigError, with file, line and column, for anything that FloorPlan would refuse and for
/// every unknown key.
FloorPlan read_floor_plan(const files::TomlReader& file);

}  // namespace echomap::world

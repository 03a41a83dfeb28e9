// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host/exploration/waypoint_course.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::strategies {

/// Reads a course: [grid] with columns, rows, cell_m and, where it does not begin at the origin,
/// the x_m and y_m of its lower left corner; [start]; [[known_wall]] with points_m, a wall from
/// each to the next; [[waypoint]] with x_m, y_m and a name. Throws files::ConfigError.
exploration::WaypointCourse read_course(const files::TomlReader& file);

/// `name_or_file` is the name of a bundled course ("playground") or a path that ends in .toml.
/// Throws files::ConfigError.
exploration::WaypointCourse load_course(const std::string& name_or_file);

}  // namespace echomap::strategies

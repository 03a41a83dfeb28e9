// SPDX-License-Identifier: MIT
#pragma once

#include "host/localization/particles.hpp"
#include "host/localization/range_table.hpp"

namespace echomap::localization {

/// All poses on the floor of a table, in steps of about `spacing_m` and `spacing_rad`: a robot that
/// may be anywhere is near one of them.
Particles floor_lattice(const RangeTable& table, double spacing_m, double spacing_rad);

}  // namespace echomap::localization

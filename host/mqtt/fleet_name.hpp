// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace echomap::mqtt {

/// Whether a fleet, a robot or a site may have this name: 1 to 32 of a-z, 0-9, _ and -. A name is
/// one level of topics, and the rights of a robot depend on it.
bool is_fleet_name(std::string_view name);

}  // namespace echomap::mqtt

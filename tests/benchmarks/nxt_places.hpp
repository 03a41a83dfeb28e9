// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace echomap::bench {

/// How many of five places a LEGO NXT knows again by its sonar, turned once round, from how they
/// sounded before.
int nxt_places_known_again(const std::filesystem::path& folder);

}  // namespace echomap::bench

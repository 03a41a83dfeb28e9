// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::world {

/// What the parts are stepped by here.
inline constexpr double kStepS = 0.001;

}  // namespace echomap::world

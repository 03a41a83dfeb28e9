// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::geometry {

/// The value times itself.
constexpr double square(double value) { return value * value; }

}  // namespace echomap::geometry

// SPDX-License-Identifier: MIT
#pragma once

#include "host/geometry/polygon.hpp"

namespace echomap::evaluation {

/// A room without symmetry, with a cupboard that stands into it.
inline const geometry::Polygon kRoom{
    {-1.5, -1.0}, {2.5, -1.0}, {2.5, 0.2}, {1.7, 0.2}, {1.7, 1.6}, {-1.1, 1.6}, {-1.5, 0.9}};

}  // namespace echomap::evaluation

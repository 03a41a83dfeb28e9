// SPDX-License-Identifier: MIT
#pragma once

#include "host/mapping/sonar_surfaces.hpp"
#include "host/mapping/surface_matching.hpp"

namespace echomap::mapping {

inline const SonarSurfaceParams kSurfaceParams;
inline const SurfaceMatchingParams kMatchingParams;

}  // namespace echomap::mapping

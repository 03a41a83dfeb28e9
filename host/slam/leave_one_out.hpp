// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "host/mapping/surface_matching.hpp"

namespace echomap::slam {

/// The features that at least two scans other than `scan` support: what these expect that one to
/// measure (leave-one-out cross-validation).
mapping::MatchedSurfaces features_of_others(const mapping::MatchedSurfaces& matched,
                                            std::size_t scan);

}  // namespace echomap::slam

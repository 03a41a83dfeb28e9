// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/drawn_map.hpp"

namespace echomap::localization {

/// 3.0 x 0.4 m.
inline const mapping::RasterMap kCorridor = tests::map_from({"##############################",
                                                             "#............................#",
                                                             "#............................#",
                                                             "##############################"},
                                                            0.1);

}  // namespace echomap::localization

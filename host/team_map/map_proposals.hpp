// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/mapping/map_placement.hpp"
#include "host/team_map/robot_map.hpp"

namespace echomap::team_map {

/// Where the second robot's map may lie in the first one's: the best by all walls and floor of
/// both, and the best by those that the last stops of either have seen. Large maps overlap by
/// chance in more wall than the true place has while little is seen by both; a window that lies in
/// the other map has all of its own there. `count` of each. All are weighed by the whole maps.
std::vector<mapping::MapPlacement> propose_placements(const RobotMap& first,
                                                      const RobotMap& second,
                                                      const mapping::MapPlacementParams& params,
                                                      std::size_t count);

}  // namespace echomap::team_map

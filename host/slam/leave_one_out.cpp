// SPDX-License-Identifier: MIT
#include "host/slam/leave_one_out.hpp"

#include <algorithm>

namespace echomap::slam {

mapping::MatchedSurfaces features_of_others(const mapping::MatchedSurfaces& matched,
                                            std::size_t scan) {
  mapping::MatchedSurfaces others;
  for (std::size_t i = 0; i < matched.features.size(); ++i) {
    const auto& supporters = matched.features[i].supporters;
    const auto count =
        std::count_if(supporters.begin(), supporters.end(), [&](const auto& supporter) {
          return supporter.first != scan;
        });
    if (count < 2) {
      continue;
    }
    others.features.push_back(matched.features[i]);
    if (i < matched.walls.size()) {
      others.walls.push_back(matched.walls[i]);
    }
  }
  return others;
}

}  // namespace echomap::slam

// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host/mapping/cell_field.hpp"
#include "host/source_search/source_belief.hpp"

namespace echomap::source_search {

/// The probability density of the source's place, per square metre, in cells of `resolution_m` of
/// the map frame: a layer of the map. Sums to the probability that there is a source, times one
/// over the area of a cell. Throws std::invalid_argument unless the resolution is above 0.
mapping::CellField source_density(const SourceBelief& belief, double resolution_m);

/// Expected reading of the sensor in the middle of each cell: pulses a second, or the level in its
/// unit. By samples of the posterior. Throws std::invalid_argument unless the resolution is above
/// 0.
mapping::CellField expected_rate(const SourceBelief& belief, double resolution_m);

/// source.json: verdict, probability of none, the best place with its region, strength and
/// background. Lengths in metres of the map frame; what is not known is null.
std::string source_json(const SourceEstimate& estimate, const SourceBeliefParams& params);

}  // namespace echomap::source_search

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/slam/data_association.hpp"

namespace echomap::slam {

/// The chi square that is exceeded by one in a hundred, of as many degrees of freedom, to 1 %
/// (Wilson and Hilferty 1931).
double chi_square_99(std::size_t degrees);

/// Joint compatibility branch and bound (Neira and Tardos 2001): of all ways to pair the sightings
/// of a scan with landmarks that are believable together, the one with the most pairs, and of these
/// the one with the least distance. A wrong pair that would be believable alone is found out by the
/// others, whose errors come from the same pose. `candidates` in the order of their sightings.
std::vector<Candidate> jointly_compatible(const EkfSlamFilter& filter,
                                          std::span<const Candidate> candidates,
                                          std::size_t max_steps);

}  // namespace echomap::slam

// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/slam/factor_graph.hpp"
#include "host/slam/multiscan_alignment.hpp"

namespace echomap::slam {

/// The begins of multiscans as nodes. An edge from each to the next is the odometry's piece, its
/// steady errors taken off as they are estimated. Another one joins two multiscans with patches
/// that match: all that these say of the way between them, linearised at the estimate. It knows
/// nothing along a single wall; its information may be singular.
FactorGraph factor_graph(const MultiscanGraph& graph,
                         const std::vector<PatchMatch>& matches,
                         std::size_t first_wide,
                         const MultiscanAlignmentParams& params);

}  // namespace echomap::slam

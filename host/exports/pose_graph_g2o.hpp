// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/slam/factor_graph.hpp"

namespace echomap::exports {

/// pose_graph.g2o: the text format of g2o (Kuemmerle et al. 2011). Lines `VERTEX_SE2 id x y theta`
/// for nodes, numbered from 0, and `VERTEX_XY id x y` for landmarks, numbered on; `FIX 0`; then
/// `EDGE_SE2 from to dx dy dtheta i11 i12 i13 i22 i23 i33` and
/// `EDGE_SE2_XY from landmark x y i11 i12 i22`, the information's upper triangle on the axes of
/// `to` and of `from`; then landmarks that are walls as comments, `# WALL from_x from_y to_x to_y`,
/// since the format has none. Metres and radians of the graph's frame; numbers are the shortest
/// that read back the same. Throws files::FileError.
void write_pose_graph_g2o(const std::filesystem::path& path, const slam::FactorGraph& graph);

}  // namespace echomap::exports

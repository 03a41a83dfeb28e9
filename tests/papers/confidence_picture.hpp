// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"
#include "host/mapping/cell_field.hpp"

namespace echomap::papers {

/// Draws a grid of confidences as figure 5 of Hennessey et al. does, with what stands there and,
/// where there is one, the way that was driven; all in the grid's frame.
void draw_confidence(const std::filesystem::path& path,
                     const mapping::CellField& confidence,
                     const world::FloorPlan& room,
                     const std::vector<Eigen::Vector2d>& path_m = {});

}  // namespace echomap::papers

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"
#include "host/mapping/cell_field.hpp"

namespace echomap::papers {

/// Draws a grid of confidences as figure 5 of Hennessey et al. does, with the true walls and, where
/// one is given, the path that was driven; all in the grid's frame. Writes it to `path` and returns
/// the bytes of the PNG file. Throws files::FileError.
std::vector<std::uint8_t> draw_confidence(const std::filesystem::path& path,
                                          const mapping::CellField& confidence,
                                          const world::FloorPlan& room,
                                          const std::vector<Eigen::Vector2d>& path_m = {});

}  // namespace echomap::papers

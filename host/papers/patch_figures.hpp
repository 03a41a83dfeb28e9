// SPDX-License-Identifier: MIT
#pragma once

#include "host/papers/playground.hpp"

namespace echomap::papers {

/// How a grid of patches agrees with its playground. Shares are 0 to 1.
struct PatchFigures {
  double boxes_found = 0.0;       ///< Share of the boxes' sides with an occupied cell within 5 cm.
  double walls_found = 0.0;       ///< The same of the room's walls.
  double occupied_rms_m = 0.0;    ///< Root mean square distance of occupied cells to any side.
  double echo_rms_m = 0.0;        ///< The same of the echoes.
  double open_floor_wrong = 0.0;  ///< Share of the floor 20 cm off everything that is occupied.
  double block = 0.0;             ///< Confidence in the face of the low block.
  double final_error_m = 0.0;     ///< Error of the position at the end.
};

/// Scores the grid of one drive. A cell is occupied from a confidence of 1 on, that of one echo.
PatchFigures patch_figures(const Playground& playground, const PatchDrive& drive);

}  // namespace echomap::papers

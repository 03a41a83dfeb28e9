// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "host/mapping/raster_map.hpp"
#include "host/terminal_view/half_block_map.hpp"
#include "host/terminal_view/run_status.hpp"
#include "host/terminal_view/terminal_kind.hpp"

namespace echomap::terminal_view {

/// All that is shown of a run at one instant.
struct RunView {
  mapping::RasterMap map;
  MapMarks marks;
  RunStatus status;
};

/// The view as lines within `room`: where it is wide the map to the left and the status to the
/// right, else the status below the map. What there is no room for is left out from the end, the
/// map where it would have less than four lines.
std::vector<std::string> lines_of(const RunView& view, TextSize room, Glyphs glyphs);

}  // namespace echomap::terminal_view

// SPDX-License-Identifier: MIT
#pragma once

#include "host/exploration/cell_values.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exploration {

/// How much of the rim of each unknown island of the map is occupied, from 0 to 1, for its cells.
/// An island hangs together by sides and has known cells all round: around the leg of a table most
/// of it is floor, while a cupboard has walls. All other cells have 1.
CellValues<float> occupied_rim_shares(const mapping::RasterMap& map);

}  // namespace echomap::exploration

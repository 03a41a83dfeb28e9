// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/pipeline/snapshot.hpp"

namespace echomap::exports {

/// map.png, the picture for people: floor white, walls dark, unknown a pale hatch; the robot's
/// trail from its start (ring) to where it stands (disc with nose), the echoes as dots, and a scale
/// bar in metres. North of the picture is +y of the map frame. tEXt chunks say where it lies
/// (MapView::texts). Throws files::FileError.
void write_map_png(const std::filesystem::path& path, const pipeline::Snapshot& snapshot);

}  // namespace echomap::exports

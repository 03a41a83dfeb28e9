// SPDX-License-Identifier: MIT
#include "host/exports/map_png.hpp"

#include "host/exports/map_drawing.hpp"
#include "host/exports/map_view.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exports {

void write_map_png(const std::filesystem::path& path,
                   const pipeline::Snapshot& snapshot,
                   const std::optional<mapping::PolygonMap>& outline,
                   const MapStyle& style) {
  const MapView view(mapping::rasterize(*snapshot.grid),
                     {.legend = legend_of(snapshot, outline.has_value(), style),
                      .title = style.title,
                      .turn_rad = style.turn_rad,
                      .points_m = held_points_m(snapshot, style)});
  draw_map(view, snapshot, outline, style).write_png(path, view.texts());
}

}  // namespace echomap::exports

// SPDX-License-Identifier: MIT
#include "host/evaluation/difference_picture.hpp"

#include "host/evaluation/map_agreement.hpp"
#include "host/exports/map_view.hpp"

namespace echomap::evaluation {
namespace {

constexpr exports::Colour kWallAfter = exports::kGreen;
constexpr exports::Colour kAppeared = exports::kVermilion;
constexpr exports::Colour kVanished = exports::kSkyBlue;

exports::Colour colour_of(ChangeKind kind) {
  return kind == ChangeKind::kAppeared ? kAppeared : kVanished;
}

/// A frame of two pixels around a region and a margin.
void draw_frame(const ChangedRegion& region,
                const exports::MapView& view,
                exports::Picture& picture) {
  constexpr double kMarginM = 0.05;
  const Eigen::Vector2d half_m = 0.5 * region.size_m + Eigen::Vector2d::Constant(kMarginM);
  const Eigen::Vector2d low = view.place(region.center_m - half_m);
  const Eigen::Vector2d high = view.place(region.center_m + half_m);
  const Eigen::Vector2d low_right(high.x(), low.y());
  const Eigen::Vector2d high_left(low.x(), high.y());
  for (const auto& [from, to] : {geometry::Segment{low, low_right},
                                 geometry::Segment{low_right, high},
                                 geometry::Segment{high, high_left},
                                 geometry::Segment{high_left, low}}) {
    picture.draw_line(from, to, 2.0, colour_of(region.kind));
  }
}

}  // namespace

void write_difference_picture(const std::filesystem::path& path,
                              const mapping::RasterMap& before,
                              const mapping::RasterMap& after,
                              const MapDifference& difference) {
  const geometry::Pose2& T_before_after = difference.alignment.T_a_b;
  const auto canvas =
      mapping::cut_out(before, cells_of_both(before, T_before_after.inverse(), after));
  const exports::MapView view(canvas,
                              {.legend = {{kAppeared, "appeared"},
                                          {kVanished, "vanished"},
                                          {exports::kWallColour, "walls before"},
                                          {kWallAfter, "walls after"}}});
  exports::Picture picture = view.draw();
  for (const ChangedRegion& region : difference.regions) {
    for (const Eigen::Vector2d& center_m : region.cells_m) {
      view.fill_cell(picture, canvas.cell_at(center_m), colour_of(region.kind));
    }
  }
  for (const Eigen::Vector2d& center_m : centers_m(after, mapping::CellState::kOccupied)) {
    picture.fill_disc(view.place(T_before_after * center_m), 2.0, kWallAfter);
  }
  for (const ChangedRegion& region : difference.regions) {
    draw_frame(region, view, picture);
  }
  picture.write_png(path, view.texts());
}

}  // namespace echomap::evaluation

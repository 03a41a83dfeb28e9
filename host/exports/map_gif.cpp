// SPDX-License-Identifier: MIT
#include "host/exports/map_gif.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "host/exports/gif_animation.hpp"
#include "host/exports/map_drawing.hpp"
#include "host/exports/map_view.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exports {
namespace {

/// As wide as a title line with a few words.
constexpr int kMinMapWidthPx = 200;
constexpr const char* kCut = "..";

MapAnimationParams validate(MapAnimationParams params) {
  geometry::ParameterValidator("map animation")
      .finite("turn_rad", params.turn_rad)
      .nonnegative_finite("robot_radius_m", params.robot_radius_m)
      .at_least("frame_ms", params.frame_ms, 20)
      .at_least("last_frame_ms", params.last_frame_ms, 20)
      .at_least("max_frames", params.max_frames, 2)
      .at_least("max_width_px", params.max_width_px, kMinMapWidthPx);
  return params;
}

/// The corners of the box around a snapshot's trail, in the map frame: few, where the trail has
/// thousands of poses.
std::vector<Eigen::Vector2d> trail_corners_m(const pipeline::Snapshot& snapshot,
                                             const MapStyle& style) {
  const PictureFrame turned{.turn_rad = style.turn_rad};
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point_m : held_points_m(snapshot, style)) {
    box.extend(turned.in_picture_m(point_m));
  }
  return {turned.in_map_m(box.min()), turned.in_map_m(box.max())};
}

std::vector<Colour> exact_colours() {
  return {kFloorColour,
          kUnknownColour,
          kWallColour,
          kInkColour,
          kEchoColour,
          kFittedColour,
          kTrailColour,
          kRobotColour,
          kOutlineColour,
          kStartColour};
}

}  // namespace

MapAnimation::MapAnimation(MapAnimationParams params) : params_(validate(std::move(params))) {}

void MapAnimation::add(const pipeline::Snapshot& snapshot,
                       const std::optional<mapping::PolygonMap>& outline,
                       std::string caption) {
  last_ = Frame{snapshot, outline, std::move(caption)};
  if (added_ % stride_ == 0) {
    frames_.push_back(*last_);
  }
  ++added_;
  if (frames_.size() > 2 * params_.max_frames) {
    for (std::size_t i = 0; 2 * i < frames_.size(); ++i) {
      std::swap(frames_[i], frames_[2 * i]);
    }
    frames_.resize((frames_.size() + 1) / 2);
    stride_ *= 2;
  }
}

std::vector<const MapAnimation::Frame*> MapAnimation::chosen_frames() const {
  std::vector<const Frame*> all;
  all.reserve(frames_.size() + 1);
  for (const Frame& frame : frames_) {
    all.push_back(&frame);
  }
  if (last_ && (added_ - 1) % stride_ != 0) {
    all.push_back(&*last_);
  }
  if (all.size() <= params_.max_frames) {
    return all;
  }
  std::vector<const Frame*> chosen;
  chosen.reserve(params_.max_frames);
  const std::size_t steps = params_.max_frames - 1;
  for (std::size_t i = 0; i <= steps; ++i) {
    chosen.push_back(all[(i * (all.size() - 1) + steps / 2) / steps]);
  }
  return chosen;
}

/// Filled with blanks, so that all titles make frames of one width.
std::string MapAnimation::title_line(const std::string& caption, std::size_t letters) const {
  const std::string tail = params_.title.empty() || caption.empty() ? caption : ", " + caption;
  std::string title = params_.title;
  if (title.size() + tail.size() > letters) {
    const std::size_t room = letters - std::min(letters, tail.size() + 2);
    title = title.substr(0, room) + kCut;
  }
  title += tail;
  title.resize(letters, ' ');
  return title;
}

void MapAnimation::save(const std::filesystem::path& path) const {
  const std::vector<const Frame*> frames = chosen_frames();
  if (frames.empty()) {
    throw files::FileError("cannot make " + path.string() + ": there is no map to show");
  }
  const Frame& last = *frames.back();
  const MapStyle style{.turn_rad = params_.turn_rad, .robot_radius_m = params_.robot_radius_m};
  std::vector<Eigen::Vector2d> points_m;
  std::size_t letters = 0;
  for (const Frame* frame : frames) {
    const auto corners_m = trail_corners_m(frame->snapshot, style);
    points_m.insert(points_m.end(), corners_m.begin(), corners_m.end());
    letters = std::max(letters, params_.title.size() + frame->caption.size() + 2);
  }
  letters = std::min(letters, MapView::title_letters(params_.max_width_px));
  const mapping::RasterMap last_map = mapping::rasterize(*last.snapshot.grid);
  const PictureFrame view_frame = frame_of(last_map, params_.turn_rad, points_m);
  GifAnimation animation(exact_colours());
  for (const Frame* frame : frames) {
    const MapView view(mapping::rasterize(*frame->snapshot.grid),
                       {.legend = legend_of(last.snapshot, last.outline.has_value(), style),
                        .title = title_line(frame->caption, letters),
                        .frame = view_frame,
                        .max_map_width_px = params_.max_width_px});
    animation.add(draw_map(view, frame->snapshot, frame->outline, style),
                  frame == &last ? params_.last_frame_ms : params_.frame_ms);
  }
  animation.save(path);
}

}  // namespace echomap::exports

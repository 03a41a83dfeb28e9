// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/mapping/polygon_map.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::exports {

/// How a MapAnimation is drawn. The defaults are ours: what a README shows well.
struct MapAnimationParams {
  /// How far all frames are turned in the map frame, counter-clockwise.
  double turn_rad = 0.0;
  double robot_radius_m = 0.09;
  /// What the title line begins with; the frame's caption follows. Cut where both do not fit.
  std::string title{};
  int frame_ms = 400;            ///< How long a frame is shown, 20 or above.
  int last_frame_ms = 3000;      ///< And the last one, before the first is shown again.
  std::size_t max_frames = 120;  ///< 2 or above.
  int max_width_px = 640;        ///< Of the map in a frame, 200 or above.
};

/// A map that grows, as a GIF file for pages: each frame is drawn as map.png is, all of them in the
/// view of the last one, so that the room stays where it is. What is added is stored as it is and
/// drawn when the file is saved.
class MapAnimation {
 public:
  /// Throws std::invalid_argument with the field, its value and its range.
  explicit MapAnimation(MapAnimationParams params = {});

  /// Appends what is known at an instant. `caption` is at the end of the title line, as "12 stops,
  /// 84 s", in the letters of picture_font.hpp. Of more than twice `max_frames` every second one is
  /// dropped.
  void add(const pipeline::Snapshot& snapshot,
           const std::optional<mapping::PolygonMap>& outline,
           std::string caption);

  /// Writes at most `max_frames` of what was added, evenly chosen; the last one is always there.
  /// The same frames make the same bytes. Throws files::FileError, also where nothing was added.
  void save(const std::filesystem::path& path) const;

 private:
  struct Frame {
    pipeline::Snapshot snapshot;
    std::optional<mapping::PolygonMap> outline;
    std::string caption;
  };

  std::vector<const Frame*> chosen_frames() const;
  std::string title_line(const std::string& caption, std::size_t letters) const;

  MapAnimationParams params_;
  /// Every `stride_`-th of what was added, from the first on.
  std::vector<Frame> frames_;
  std::optional<Frame> last_;
  std::size_t added_ = 0;
  std::size_t stride_ = 1;
};

}  // namespace echomap::exports

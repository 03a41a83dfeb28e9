// SPDX-License-Identifier: MIT
#include "host/apps/live_score.hpp"

#include "host/evaluation/obstacle_agreement.hpp"
#include "host/files/atomic_file.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::apps {
namespace {

using nlohmann::ordered_json;

template <class Value>
ordered_json number_or_null(const std::optional<Value>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

}  // namespace

LiveScore::LiveScore(const std::filesystem::path& truth) : truth_(evaluation::read_truth(truth)) {
  if (truth_.trajectory.empty()) {
    throw files::FileError((truth / "truth.tum").string() + ": holds no pose");
  }
}

void LiveScore::look_at(const mapping::OccupancyGrid& grid) {
  const geometry::Pose2& T_world_map = truth_.trajectory.front().T_world_robot;
  const mapping::RasterMap map = mapping::rasterize(grid);
  const auto agreement = evaluation::score_map(map, T_world_map, truth_.map);
  const auto obstacles = evaluation::score_obstacles(map, T_world_map, truth_.map);
  map_ = {{"free_iou", agreement.free_iou},
          {"wall_rmse_m", number_or_null(agreement.wall_rmse_m)},
          {"solid_called_free", number_or_null(obstacles.solid_called_free)},
          {"objects_found", nullptr}};
  if (obstacles.objects > 0) {
    map_["objects_found"] =
        static_cast<double>(obstacles.objects_found) / static_cast<double>(obstacles.objects);
  }
}

ordered_json LiveScore::json(const geometry::Pose2& T_map_robot,
                             const std::optional<geometry::Pose2>& T_map_true_robot) const {
  ordered_json score = map_;
  score["pose_error_m"] = nullptr;
  if (T_map_true_robot) {
    score["pose_error_m"] = (T_map_robot.position_m() - T_map_true_robot->position_m()).norm();
  }
  return score;
}

}  // namespace echomap::apps

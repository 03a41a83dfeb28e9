// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_atlas.hpp"

#include <cmath>
#include <utility>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::pipeline {
namespace {

RobotPipeline replayed(const ObservationLog& record, RobotPipeline pipeline) {
  record.replay(pipeline);
  return pipeline;
}

mapping::PlaceableMap map_of(const RobotPipeline& pipeline) {
  return mapping::PlaceableMap(mapping::rasterize(*pipeline.snapshot().grid));
}

}  // namespace

RobotAtlas::RobotAtlas(MakePipeline make, const RobotAtlasParams& params)
    : make_(std::move(make)), params_(params), pipeline_(make_()) {
  geometry::ParameterValidator("robot atlas")
      .positive("agreeing_stops", params.agreeing_stops)
      .positive("same_m", params.same_m)
      .positive("same_rad", params.same_rad);
}

void RobotAtlas::on(const sensors::Observation& observation) {
  record_.on(observation);
  hand_on(observation, pipeline_);
}

void RobotAtlas::begin_new_map(std::size_t stops_elsewhere) {
  const bool is_lifted = pipeline_.snapshot().times_lifted > 0;
  ObservationLog later = is_lifted ? record_.split_off_lift() : record_.split_off(stops_elsewhere);
  if (!is_lifted && stops_elsewhere > 1) {
    later = later.split_off(stops_elsewhere - 1);  // The first may be of both places.
  }
  if (record_.scans() > 0 && params_.keeps_previous_maps) {
    set_aside(std::move(record_));
  }
  take(std::move(later));
  ++changes_;
}

void RobotAtlas::set_aside(ObservationLog record) {
  RobotPipeline pipeline = replayed(record, make_());
  mapping::PlaceableMap map = map_of(pipeline);
  previous_.push_back({std::move(record), std::move(pipeline), std::move(map), std::nullopt, 0});
  ++changes_;
}

bool RobotAtlas::join() {
  if (previous_.empty()) {
    return false;
  }
  const mapping::PlaceableMap map = map_of(pipeline_);
  for (std::size_t i = previous_.size(); i-- > 0;) {
    if (look_in(previous_[i], map)) {
      const PreviousMap found = std::move(previous_[i]);
      previous_.erase(previous_.begin() + static_cast<std::ptrdiff_t>(i));
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): look_in() has set it
      take(joined(found.record, record_, *found.T_previous_map));
      ++joins_;
      ++changes_;
      return true;
    }
  }
  return false;
}

bool RobotAtlas::look_in(PreviousMap& previous, const mapping::PlaceableMap& map) const {
  const auto placement = mapping::sure_placement(
      mapping::find_placements(previous.map, map, params_.placement), params_.placement);
  if (!placement) {
    previous.agreeing_stops = 0;
    return false;
  }
  const auto& T_previous_map = placement->T_previous_later;
  const geometry::Pose2 T_before_now =
      previous.T_previous_map.value_or(T_previous_map).inverse() * T_previous_map;
  const bool agrees = T_before_now.position_m().norm() <= params_.same_m &&
                      std::abs(T_before_now.heading_rad()) <= params_.same_rad;
  previous.agreeing_stops = agrees ? previous.agreeing_stops + 1 : 1;
  previous.T_previous_map = T_previous_map;
  return previous.agreeing_stops >= params_.agreeing_stops;
}

void RobotAtlas::take(ObservationLog record) {
  for (PreviousMap& previous : previous_) {
    previous.agreeing_stops = 0;
  }
  record_ = std::move(record);
  pipeline_ = replayed(record_, make_());
}

}  // namespace echomap::pipeline

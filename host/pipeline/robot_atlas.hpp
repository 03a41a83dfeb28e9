// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "host/mapping/map_placement.hpp"
#include "host/pipeline/observation_log.hpp"
#include "host/pipeline/robot_pipeline.hpp"

namespace echomap::pipeline {

/// When two maps of an atlas are joined. Values are ours, chosen in simulated rooms.
struct RobotAtlasParams {
  mapping::MapPlacementParams placement;
  /// Number of consecutive stops that must agree on the placement, within same_m and same_rad.
  std::size_t agreeing_stops = 2;
  double same_m = 0.3;
  double same_rad = 0.17;
  /// False where nobody will join them: maps that are left are let go.
  bool keeps_previous_maps = true;
};

/// A map that was set aside when the robot was carried away from it.
struct PreviousMap {
  ObservationLog record;
  RobotPipeline pipeline;
  mapping::PlaceableMap map;  ///< Map of the pipeline, which no longer changes.
  /// Placement of the current map in this one as of the last stops, and the number of consecutive
  /// stops that agree.
  std::optional<geometry::Pose2> T_previous_map;
  std::size_t agreeing_stops = 0;
};

/// The maps of a robot that may be carried off while it explores: that which it is in, and those
/// before it, until it is known where they lie (an atlas: Elvira, Tardos and Montiel 2019). Every
/// map is what a pipeline makes of its record.
class RobotAtlas final : public AnyObservationSink {
 public:
  using MakePipeline = std::function<RobotPipeline()>;

  /// `make` makes empty pipelines, all of one kind.
  explicit RobotAtlas(MakePipeline make, const RobotAtlasParams& params = {});

  void on(const sensors::Observation& observation) override;

  /// The robot was picked up, or else its last stops are of another place than its map: the map
  /// without them is set aside, and they begin a new one. A map without any stop is let go.
  void begin_new_map(std::size_t stops_elsewhere);

  /// Adds an earlier map of the same robot in front of those in the atlas.
  void set_aside(ObservationLog record);

  /// To be called after a stop: looks for the robot's map in the previous ones, the latest first,
  /// and joins it to one where it has found it for some stops in a row. Answers whether it has.
  bool join();

  /// Pipeline of the current map; the reference stays valid.
  RobotPipeline& pipeline() { return pipeline_; }
  const RobotPipeline& pipeline() const { return pipeline_; }
  const ObservationLog& record() const { return record_; }
  /// The previous maps, the earliest first.
  const std::vector<PreviousMap>& previous_maps() const { return previous_; }
  /// Number of times that maps were joined.
  std::size_t joins() const { return joins_; }
  /// Number of times that a map was started, set aside or joined.
  std::size_t changes() const { return changes_; }

 private:
  void take(ObservationLog record);
  bool look_in(PreviousMap& previous, const mapping::PlaceableMap& map) const;

  MakePipeline make_;
  RobotAtlasParams params_;
  ObservationLog record_;
  RobotPipeline pipeline_;
  std::vector<PreviousMap> previous_;
  std::size_t joins_ = 0;
  std::size_t changes_ = 0;
};

}  // namespace echomap::pipeline

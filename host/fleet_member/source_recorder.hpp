// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/fleet_messages/conversions.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/source_search/source_readings.hpp"
#include "host/team_map/submap_recorder.hpp"

namespace echomap::fleet_member {

/// Collects what a robot's scalar sensor reads, in the odometry frame of its submaps, for
/// publication. It receives the observations that the recorder of the submaps receives, after it.
class SourceRecorder final : public pipeline::AnyObservationSink {
 public:
  /// `submaps` must outlive this. A batch holds readings of `batch_s` seconds or more. Throws
  /// std::invalid_argument for invalid parameters.
  SourceRecorder(const team_map::SubmapRecorder& submaps,
                 const source_search::SourceReadingsParams& params,
                 double batch_s);

  void on(const sensors::Observation& observation) override;

  /// Readings since the last batch, once that is long enough and there is a submap. Consecutive
  /// readings are merged as source_search::SourceReadings does.
  std::optional<fleet_messages::SourceBatch> take();
  /// All readings since the last batch, however few.
  std::optional<fleet_messages::SourceBatch> take_rest();

 private:
  void add(const sensors::ScalarObservation& observation);
  void end_row();
  std::optional<fleet_messages::SourceBatch> batch();

  const team_map::SubmapRecorder& submaps_;
  source_search::SourceReadingsParams params_;
  double batch_s_;
  Eigen::Vector2d last_m_ = Eigen::Vector2d::Zero();  ///< Place of the previous reading.
  bool has_last_ = false;
  fleet_messages::SourceReading row_;
  Eigen::Vector2d row_first_m_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d row_sum_m_s_ = Eigen::Vector2d::Zero();  ///< Of places times dwells.
  std::vector<fleet_messages::SourceReading> rows_;
  double batch_begin_s_ = 0.0;
};

}  // namespace echomap::fleet_member

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/map_placement.hpp"
#include "host/team_map/map_evidence.hpp"
#include "host/team_map/robot_map.hpp"

namespace echomap::team_map {

/// When a comparison of two maps is sure. Values are ours, chosen in simulated rooms
/// (docs/algorithms/team_map.md).
struct SureEvidence {
  /// Largest loss of log-likelihood per reading: a sure placement explains readings about as well
  /// as each map explains its own.
  double max_loss = 0.18;
  /// Smallest number of readings in the overlap, and smallest gain of log-likelihood over no map.
  double min_readings = 300.0;
  double min_gain = 450.0;
  /// Smallest number of surfaces that both have measured, and their share of those that both should
  /// have.
  std::size_t min_matched = 20;
  double min_matched_share = 0.7;
  /// Largest share of its weight by readings that any other placement may have,
  double max_rival_share = 0.7;
  /// and by walls (mapping::MapPlacement). Placements that lose more than refuted_loss per reading,
  /// over min_readings, do not count there: their readings contradict their walls.
  double max_rival_wall_share = 0.85;
  double refuted_loss = 1.0;
};

/// When the maps of two robots are joined, and when a join is undone. Values are ours as well.
struct MapJoinParams {
  mapping::MapPlacementParams placement;
  /// Smallest number of stops of a map to join: fewer show one place, which may look like others.
  std::size_t min_stops = 3;
  /// Number of the best placements by walls and floor that are scored by readings.
  std::size_t max_scored_placements = 24;
  /// When a comparison is sure, and how many in a row have to agree within same_m and same_rad.
  SureEvidence sure;
  std::size_t agreeing_looks = 2;
  double same_m = 0.3;
  double same_rad = 0.17;
  /// A join is undone that loses more than this per reading, or that another placement outdoes by
  /// readings (SureEvidence::max_rival_share) and walls, in undoing_looks comparisons in a row.
  double undone_loss = 0.8;
  std::size_t undoing_looks = 2;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const MapJoinParams& params);

/// A placement of the second map in the first one, and its evidence.
struct ScoredPlacement {
  geometry::Pose2 T_first_second;
  MapEvidence evidence;
  double wall_weight_m = 0.0;  ///< mapping::MapPlacement::weight_m.
};

/// Relative pose of the maps of two robots, as far as it is known. It is searched after every stop
/// of either; a join stays revocable.
class MapJoin {
 public:
  explicit MapJoin(const MapJoinParams& params) : params_(params) {}

  /// Searches the second robot's map in that of the first, or checks the join that there is.
  void update(const RobotMap& first, const RobotMap& second);

  /// Checks a placement that joins with other maps imply, and joins the two maps there if their own
  /// readings are sure of it, too.
  void try_at(const RobotMap& first, const RobotMap& second, const geometry::Pose2& T_first_second);
  /// Adopts a join that other robots have made, to be checked like any join; not where one has been
  /// undone here. Returns whether it is new.
  bool accept_join(const geometry::Pose2& T_first_second);
  /// Whether the last calls of try_at in a row, as many as undo a join, contradicted their
  /// placement.
  bool is_contradicted() const { return contradicting_ >= params_.undoing_looks; }
  /// Undoes the join, where something else has contradicted it.
  void undo();

  /// From the second robot's map to the first one's; empty while it is not known.
  const std::optional<geometry::Pose2>& T_first_second() const { return joined_; }
  /// Placements that were scored last, the best first; of a join, that alone.
  const std::vector<ScoredPlacement>& scored() const { return scored_; }
  /// Weight of the join as of the last comparison (MapEvidence::weight).
  double weight() const { return scored_.empty() ? 0.0 : scored_.front().evidence.weight(); }
  std::size_t joins() const { return joins_; }
  /// Number of joins that were contradicted later.
  std::size_t undone() const { return undone_; }

 private:
  bool are_large_enough(const RobotMap& first, const RobotMap& second) const;
  /// Placements that walls propose, refined and scored, the best first.
  std::vector<ScoredPlacement> proposals(const RobotMap& first, const RobotMap& second) const;
  void look(const RobotMap& first, const RobotMap& second);
  void check(const RobotMap& first, const RobotMap& second);
  void join(const geometry::Pose2& T_first_second);
  bool is_sure() const;
  bool has_rival() const;
  bool is_outdone(const ScoredPlacement& join, const std::vector<ScoredPlacement>& proposals) const;

  MapJoinParams params_;
  std::vector<ScoredPlacement> scored_;
  std::optional<geometry::Pose2> candidate_;
  std::size_t agreeing_ = 0;
  std::optional<geometry::Pose2> joined_;
  std::size_t contradicting_ = 0;
  std::size_t joins_ = 0;
  std::size_t undone_ = 0;
};

}  // namespace echomap::team_map

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

/// When a look at two maps is sure; ours, chosen in simulated rooms (docs/algorithms/team_map.md).
struct SureEvidence {
  /// A placement is sure that explains the readings about as well as each map its own: so much is
  /// lost at most of the log-likelihood of a reading,
  double max_loss = 0.18;
  /// over so many readings at least, which it explains by so much better than no map,
  double min_readings = 300.0;
  double min_gain = 450.0;
  /// with so many surfaces that both have seen, as such a share of those that they should have,
  std::size_t min_matched = 20;
  double min_matched_share = 0.7;
  /// such a share of its weight at most speaks for any other place, by readings,
  double max_rival_share = 0.7;
  /// and by walls (mapping::MapPlacement), of which it has the most; but for places that lose more
  /// than this of a reading, over min_readings: there readings speak against what walls say.
  double max_rival_wall_share = 0.85;
  double refuted_loss = 1.0;
};

/// When the maps of two robots are joined, and when they are taken apart again; ours as well.
struct MapJoinParams {
  mapping::MapPlacementParams placement;
  /// A map of fewer stops shows one place, which may look like others: it is not joined.
  std::size_t min_stops = 3;
  /// Of the placements that walls and floor speak for, so many of the best are judged by readings.
  std::size_t judged = 24;
  /// So many looks in a row agree on it, within same_m and same_rad.
  SureEvidence sure;
  std::size_t agreeing_looks = 2;
  double same_m = 0.3;
  double same_rad = 0.17;
  /// A join is undone that loses more than this of a reading, or that another place outdoes by
  /// readings (SureEvidence::max_rival_share) and walls, so many looks in a row.
  double undone_loss = 0.8;
  std::size_t undoing_looks = 2;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const MapJoinParams& params);

/// A place of the second map in the first one, and what speaks for it.
struct JudgedPlacement {
  geometry::Pose2 T_first_second;
  MapEvidence evidence;
  double wall_weight_m = 0.0;  ///< mapping::MapPlacement::weight_m.
};

/// How the maps of two robots lie to each other, as far as is known. Looked for after every stop of
/// either; what was found stays revocable.
class MapJoin {
 public:
  explicit MapJoin(const MapJoinParams& params) : params_(params) {}

  /// Looks for the second robot's map in that of the first, or checks the join that there is.
  void update(const RobotMap& first, const RobotMap& second);

  /// The same where others tell how the two lie to each other: joins them there if their readings
  /// are sure of it, too.
  void try_at(const RobotMap& first, const RobotMap& second, const geometry::Pose2& T_first_second);
  /// Others have joined the two there: so they are here, too, to be checked like any join, unless
  /// one has been undone here. Answers whether that is new.
  bool believe(const geometry::Pose2& T_first_second);
  /// Whether the last tries in a row, as many as undo a join, spoke against that place.
  bool is_contradicted() const { return contradicting_ >= params_.undoing_looks; }
  /// Takes the join back: something else has contradicted it.
  void undo();

  /// From the second robot's map to the first one's; empty while it is not known.
  const std::optional<geometry::Pose2>& T_first_second() const { return joined_; }
  /// What was judged last, the best first; of a join, that alone.
  const std::vector<JudgedPlacement>& judged() const { return judged_; }
  /// What speaks for the join, as of the last look (MapEvidence::weight).
  double weight() const { return judged_.empty() ? 0.0 : judged_.front().evidence.weight(); }
  std::size_t joins() const { return joins_; }
  /// How often a join was contradicted later.
  std::size_t undone() const { return undone_; }

 private:
  bool are_large_enough(const RobotMap& first, const RobotMap& second) const;
  /// Places that walls propose, refined and judged, the best first.
  std::vector<JudgedPlacement> proposals(const RobotMap& first, const RobotMap& second) const;
  void look(const RobotMap& first, const RobotMap& second);
  void check(const RobotMap& first, const RobotMap& second);
  void join(const geometry::Pose2& T_first_second);
  bool is_sure() const;
  bool has_rival() const;
  bool is_outdone(const JudgedPlacement& join, const std::vector<JudgedPlacement>& proposals) const;

  MapJoinParams params_;
  std::vector<JudgedPlacement> judged_;
  std::optional<geometry::Pose2> candidate_;
  std::size_t agreeing_ = 0;
  std::optional<geometry::Pose2> joined_;
  std::size_t contradicting_ = 0;
  std::size_t joins_ = 0;
  std::size_t undone_ = 0;
};

}  // namespace echomap::team_map

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "host/geometry/pose2.hpp"
#include "host/mapping/map_placement.hpp"
#include "host/team_map/robot_map.hpp"

namespace echomap::team_map {

/// When the maps of two robots are joined, and when they are taken apart again; ours, chosen in
/// simulated rooms.
struct MapJoinParams {
  mapping::MapPlacementParams placement;
  /// So many stops of the two in a row agree on the placement, within same_m and same_rad.
  std::size_t agreeing_stops = 2;
  double same_m = 0.3;
  double same_rad = 0.17;
  /// A join is undone where less than this share of the walls that both know supports it,
  double min_kept_share = 0.3;
  /// or where another placement has this much more support than it.
  double undoing_lead_m = 3.0;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const MapJoinParams& params);

/// How the maps of two robots lie to each other, as far as is known. Looked for after every stop of
/// either; what was found stays revocable.
class MapJoin {
 public:
  explicit MapJoin(const MapJoinParams& params) : params_(params) {}

  /// Looks for the second robot's map in that of the first, or checks the join that there is.
  void update(const RobotMap& first, const RobotMap& second);

  /// From the second robot's map to the first one's; empty while it is not known.
  const std::optional<geometry::Pose2>& T_first_second() const { return joined_; }
  /// Wall that the two maps have in common there, metres of both maps together.
  double common_m() const { return common_m_; }
  std::size_t joins() const { return joins_; }
  /// How often a join was contradicted later.
  std::size_t undone() const { return undone_; }

 private:
  void look(const std::vector<mapping::MapPlacement>& placements);
  void check(const std::vector<mapping::MapPlacement>& placements);
  bool is_same(const geometry::Pose2& one, const geometry::Pose2& other) const;

  MapJoinParams params_;
  std::optional<geometry::Pose2> candidate_;
  std::size_t agreeing_stops_ = 0;
  std::optional<geometry::Pose2> joined_;
  double common_m_ = 0.0;
  std::size_t joins_ = 0;
  std::size_t undone_ = 0;
};

}  // namespace echomap::team_map

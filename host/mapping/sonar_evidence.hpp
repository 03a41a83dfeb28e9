// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/geometry/segment.hpp"
#include "host/mapping/cell_field.hpp"
#include "host/mapping/sonar_cone_mapper.hpp"
#include "host/mapping/sonar_fan.hpp"

namespace echomap::mapping {

/// A beam that something answered.
struct SonarEcho {
  double bearing_rad = 0.0;
  double range_m = 0.0;
};

/// The evidence of all views, found in rounds: free floor first, then each echo's evidence to those
/// cells of its arc that free floor does not contradict (docs/algorithms/sonar_cone.md).
class SonarEvidence {
 public:
  /// The arguments have to outlive this. Throws std::length_error for views too far apart.
  SonarEvidence(const std::vector<SonarView>& views,
                const std::vector<geometry::Segment>& walls,
                const models::SonarCone& cone,
                const SonarConeMapperParams& params);

  /// Runs all rounds.
  void find();

  /// After find().
  OccupancyGrid grid() const;
  SonarReadingCounts counts() const;

 private:
  struct ArcCell {
    std::uint32_t cell = 0;  ///< Of the fields.
    std::uint32_t step = 0;  ///< Of the view's fan, in front of the cell.
    float weight = 0.0F;     ///< Of the angle off the axis.
    float reached = 0.0F;    ///< Chance that the sound gets there.
    float share = 0.0F;      ///< Evidence for an obstacle, log-odds.
  };
  /// Where one echo may come from, cell by cell.
  struct Arc {
    std::vector<ArcCell> cells;
    bool behind_wall = false;
    bool seen_through = false;
  };

  void draw_walls(const std::vector<geometry::Segment>& walls);
  Arc arc_of(const SonarView& view, const SonarEcho& echo) const;
  void add_free_floor(const SonarFan& fan, CellField& free) const;
  void add_floor_under_robot(const SonarView& view, CellField& free) const;
  void find_opacity();
  void add_silent_floor();
  void share_out(Arc& arc) const;
  void add_arcs(const std::vector<Arc>& arcs);
  /// Chance that sound ends at the point, by what was known when the round began.
  float opacity(const Eigen::Vector2d& point_m) const;

  const std::vector<SonarView>& views_;
  const models::SonarCone& cone_;
  const SonarConeMapperParams& params_;
  FanRays rays_;
  CellField free_;
  CellField occupied_;
  CellField wall_;
  CellField opacity_;
  CellField of_one_view_;
  std::vector<std::vector<Arc>> arcs_;  ///< By view.
};

}  // namespace echomap::mapping

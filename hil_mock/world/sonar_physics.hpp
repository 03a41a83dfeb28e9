// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/noise.hpp"
#include "hil_mock/world/robot_params.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::world {

/// What sound has come back from.
enum class ReturnKind : std::uint8_t { kWall, kNiche, kEdge, kGhost };

/// Something that may answer a ping.
struct SonarReturn {
  /// Half of the sound's way.
  double range_m = 0.0;
  /// Chance to be heard, 0 .. 1.
  double strength = 0.0;
  ReturnKind kind = ReturnKind::kWall;
};

/// A sonar with a real cone in a room: sound leaves in a fan of rays, weaker off the axis; walls
/// answer near the perpendicular, niches and edges at any angle, and two mirrors make a ghost.
/// The first answer that is strong enough is the reading.
class SonarPhysics {
 public:
  /// `plan` must outlive this. Throws std::invalid_argument for a cone or range that is none.
  SonarPhysics(const FloorPlan& plan, const SonarParams& params);

  /// Everything within range that may answer, in no order; frame of the sonar: x along its axis.
  std::vector<SonarReturn> returns(const geometry::Pose2& T_world_sonar) const;

  /// The nearest return of more than the strength `threshold`.
  std::optional<SonarReturn> first_return(const geometry::Pose2& T_world_sonar,
                                          double threshold) const;

  /// One reading with its luck and noise, in metres; empty where nothing answered. Always draws
  /// the same number of random values.
  std::optional<double> ping_m(const geometry::Pose2& T_world_sonar, NoiseStream& noise) const;

 private:
  double beam_strength(double off_axis_rad) const;
  double wall_strength(double incidence_rad, Material material) const;
  void add_ray(const Eigen::Vector2d& origin_m,
               const Eigen::Vector2d& direction,
               double beam,
               std::vector<SonarReturn>& found) const;
  void add_corner(const geometry::Pose2& T_world_sonar,
                  const Corner& corner,
                  std::vector<SonarReturn>& found) const;
  void add(const SonarReturn& candidate, std::vector<SonarReturn>& found) const;

  const FloorPlan& plan_;
  SonarParams params_;
};

}  // namespace echomap::world

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/explorer.hpp"
#include "host/exploration/front_view.hpp"
#include "host/exploration/round_sweep.hpp"
#include "host/exploration/waypoint_course.hpp"
#include "host/localization/gyro_odometry.hpp"
#include "host/mapping/patch_grid.hpp"

namespace echomap::exploration {

/// Values are those of Hennessey et al., section II, where they give one; the others are ours,
/// chosen in simulation (docs/algorithms/tangent_bug.md).
struct TangentBugParams {
  RoundSweepParams sweep;
  models::GaussianPatchParams patch;
  localization::HeadingFilterParams heading = localization::heading_by_moves();
  /// A waypoint is reached within this of it: 30 cm (section II.B).
  double reached_m = 0.30;
  /// So many moves for a waypoint, then the next one (section II.E).
  std::size_t max_moves = 5;
  /// Half of the view that counts: 180 degrees in all (section II.A).
  double half_view_rad = 1.5707963267948966;
  /// A move goes no farther before the next look.
  double max_move_m = 0.8;
  /// A shorter move is not worth a look.
  double min_move_m = 0.10;
  /// Neighbours in the view that differ by more are a discontinuity.
  double jump_m = 0.25;
  /// The robot heads for "the point that is a set distance before the discontinuity".
  double before_m = 0.15;
  /// What answers nothing counts as this far.
  double max_m = 2.5;
  /// The rectangle in front is as wide as the body and this on either side.
  double side_clearance_m = 0.03;
  /// It is clear where its cells add up to less.
  double clear_sum = 16.0;
  /// An opening is narrow where it is less wide than the body and this.
  double narrow_clearance_m = 0.0;
  /// From the middle of the axle to the farthest part of the hull (robot profile).
  double robot_radius_m = 0.10;
  /// Distance to back off after a bump.
  double back_off_m = 0.08;
  /// Between two ways that are tried where no discontinuity leads on.
  double boundary_step_rad = 0.17453292519943295;
  /// Our departure from the paper, which takes nothing away, 0: an echo takes away what others have
  /// put so far off its axis and nearer than itself. Of the beam's half angle, as its edge is soft.
  double clear_half_angle_share = 0.9;
  /// It takes nothing away so near to itself: a patch's radius and the noise of a range.
  double clear_margin_m = 0.15;
  /// Half of the cone in which the sonar hears (robot profile).
  double beam_half_angle_rad = 0.2862;
};

/// The paper as it stands: nothing is ever taken away from the grid, and so the sum that is called
/// clear has to be larger.
TangentBugParams as_printed(TangentBugParams params);

/// One way point, and what became of it.
struct PhaseReport {
  std::string name;
  bool was_reached = false;
  std::size_t moves = 0;
};

/// Strategy `tangent-bug`, the exploration of Hennessey et al., section II: from waypoint to
/// waypoint, after each move a look all round; straight for the waypoint where a rectangle of the
/// confidence grid in front is clear, else to a point before a discontinuity of the view. Where it
/// is, it knows by wheels and gyro alone.
class TangentBug final : public Explorer {
 public:
  /// Throws std::invalid_argument for invalid parameters and a course without waypoints.
  TangentBug(const TangentBugParams& params, WaypointCourse course);

  Motion next(const pipeline::Snapshot& snapshot, MotionResult last) override;

  /// The paper's grid, in the course's frame, and how many waypoints were reached.
  StrategyProducts products() const override;

  /// One for each waypoint of the course.
  const std::vector<PhaseReport>& phases() const { return phases_; }

 private:
  enum class Activity : std::uint8_t { kSensing, kMoving, kBackingOff };

  void note(MotionResult last);
  void plan_sensing(const pipeline::Snapshot& snapshot);
  void add_echoes(const pipeline::Snapshot& snapshot);
  void plan_move(const pipeline::Snapshot& snapshot);
  void pass_reached();
  bool has_waypoint() const { return current_ < phases_.size(); }
  FinishReason outcome() const;

  std::optional<Eigen::Vector2d> choose_offset_m(const pipeline::Snapshot& snapshot);
  std::optional<Eigen::Vector2d> offset_past_obstacle_m(const pipeline::Snapshot& snapshot,
                                                        const Eigen::Vector2d& goal_m) const;
  std::optional<Eigen::Vector2d> way_along_boundary_m(const Eigen::Vector2d& goal_m);
  std::optional<Eigen::Vector2d> offset_out_m();
  bool is_clear(const Eigen::Vector2d& offset_m) const;

  TangentBugParams params_;
  WaypointCourse course_;
  mapping::PatchGrid grid_;
  localization::GyroOdometry odometry_;
  geometry::Pose2 T_course_robot_;
  std::vector<PhaseReport> phases_;
  std::vector<Eigen::Vector2d> trail_m_;  ///< Stops that it has left, the last one last.
  std::size_t current_ = 0;               ///< The waypoint that it is heading for.
  int followed_side_ = 0;  ///< 1 while it follows a boundary to the left, -1 to the right.
  Activity activity_ = Activity::kMoving;
  std::deque<Motion> plan_;
  bool sweeping_ = false;        ///< The last motion was a sweep.
  std::size_t sweeps_done_ = 0;  ///< At this stop.
};

}  // namespace echomap::exploration

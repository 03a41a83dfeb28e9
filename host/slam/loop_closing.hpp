// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/slam/key_frames.hpp"
#include "host/slam/loop_search.hpp"
#include "host/slam/scan_matching.hpp"
#include "host/slam/surface_field.hpp"
#include "host/slam/view_agreement.hpp"

namespace echomap::slam {

/// How loops are found and what proves them.
struct LoopClosingParams {
  /// Frames nearer than this along the way are matched by tracking, metres.
  double min_travelled_m = 8.0;
  /// How far the pose may have drifted (1 sigma): so much, and more by the way around the loop.
  /// Places are looked for within twice as much, so within 6 m at most.
  double drift_m = 0.2;
  double drift_m_per_m = 0.01;
  double max_drift_m = 3.0;
  double drift_rad = 0.05;
  double drift_rad_per_m = 0.003;
  double max_drift_rad = 0.4;
  /// A place is as well seen from so far away, metres; it may be twice the drift farther.
  double sight_m = 2.0;
  /// The frames within such a way of a place, and of the robot, are compared, metres.
  double patch_m = 4.0;
  /// A drift of no more than this is matched at once; more is searched for first.
  double near_m = 0.4;
  /// What a loop has to show: share of points on surfaces, share of points that the other side
  /// would have seen through, points that the other side has met.
  double min_share = 0.4;
  double max_contradicted = 0.1;
  std::size_t min_met = 60;
  double view_margin_m = 0.3;
  /// And, where it was searched for: so much information in the direction that is known worst, of
  /// that in the one known best. Along a corridor any place is as good as the next.
  double min_determined = 0.03;
  /// A match of two patches may be off by so much that its points do not tell.
  double spread_m = 0.03;
  double spread_rad = 0.01;
  /// A searched loop counts when the next one moves the map the same way, to within:
  double agreement_m = 0.3;
  double agreement_rad = 0.06;
  /// It is forgotten when another was found that disagrees, and after so many frames.
  std::size_t agreement_frames = 6;
};

/// Finds where the robot is back at a place it has been to, and proves it before it is believed.
class LoopClosing {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  LoopClosing(const LoopClosingParams& params,
              const LoopSearchParams& search,
              const ScanMatchingParams& matching,
              const SurfaceFieldParams& field);

  /// The edges that the newest frame proves: none, one, or two where it confirms an earlier one.
  std::vector<PoseEdge> close(const KeyFrames& frames);

 private:
  /// A frame that may be near, and how far the robot may have drifted since it was.
  struct Candidate {
    std::size_t frame = 0;
    double drift_m = 0.0;
    double drift_rad = 0.0;
  };
  struct Expected {
    geometry::Pose2 T_map_newest;
    Candidate candidate;
  };

  std::optional<Candidate> candidate(const KeyFrames& frames,
                                     const std::vector<NearFrame>& reached) const;
  /// Whether the robot may have drifted too far for a match to begin where it believes to be.
  bool is_searched(const Candidate& candidate) const;
  std::optional<PoseEdge> matched(const KeyFrames& frames,
                                  const std::vector<NearFrame>& reached,
                                  const Candidate& candidate);
  /// The points around the newest frame, in its frame.
  std::vector<Eigen::Vector2d> newest_patch_m(const KeyFrames& frames,
                                              const std::vector<NearFrame>& reached) const;
  /// The frames around an old one that tracking does not match with.
  std::vector<std::size_t> old_patch(const KeyFrames& frames,
                                     const std::vector<NearFrame>& reached,
                                     std::size_t middle) const;
  std::optional<localization::PoseGaussian> start_of_match(
      const std::vector<Eigen::Vector2d>& map_points_m,
      const std::vector<Eigen::Vector2d>& points_m,
      const Expected& expected);
  /// Whether the points tell where the robot is in each direction.
  bool is_determined(const ScanMatch& match) const;
  static bool is_within_drift(const geometry::Pose2& T_newest_matched, const Candidate& candidate);
  /// Whether neither side sees through what the other has met.
  bool is_seen_alike(const KeyFrames& frames,
                     const std::vector<std::size_t>& old_frames,
                     const geometry::Pose2& T_map_newest) const;
  ViewAgreement look(const KeyFrame& from,
                     const geometry::Pose2& T_from_points,
                     const std::vector<Eigen::Vector2d>& points_m) const;
  /// Whether two loops move the map, as it is now, the same way.
  bool agree(const KeyFrames& frames, const PoseEdge& one, const PoseEdge& other) const;

  LoopClosingParams params_;
  LoopSearch search_;
  ScanMatcher matcher_;
  SurfaceField field_;
  std::optional<PoseEdge> waiting_;  ///< A searched loop that no other has confirmed yet.
};

}  // namespace echomap::slam

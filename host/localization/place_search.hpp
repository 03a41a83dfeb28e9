// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/localization/observation_model.hpp"
#include "host/localization/particles.hpp"
#include "host/localization/stop_scan.hpp"

namespace echomap::localization {

/// Settings of a PlaceSearch, chosen in the simulated rooms of docs/algorithms/localization.md.
struct PlaceSearchParams {
  /// Scans that are kept: over more, odometry is too far off to take them together.
  std::size_t max_scans = 8;
  /// Spacing of the poses that are looked at first.
  double lattice_m = 0.2;
  double lattice_rad = 0.1963495;  ///< 11.25 degrees.
  /// So many of them, the likeliest, are refined.
  std::size_t candidates = 40;
  /// Poses that differ by no more than both are one place.
  double same_place_m = 0.5;
  double same_place_rad = 0.5;
  /// Readings of one scan are compared by sectors of so many to a turn, those of the way there by
  /// as many pieces; neighbours err together, so that only this share of them counts.
  std::size_t sectors = 6;
  double independent_share = 0.7;
};

/// A place from which a robot may have heard what it heard.
struct FoundPlace {
  geometry::Pose2 T_map_robot;  ///< At the newest scan.
  /// Natural logarithm, the mean over the sectors of a reading's mean in each.
  double log_likelihood = 0.0;
  /// How probable it is against the place with the greatest likelihood, which has 1.
  double odds = 1.0;
  bool is_believed = false;  ///< It is the place that the caller believes.
};

/// Looks for a robot in a whole map by its last scans together: what one scan cannot tell apart,
/// several often can. Unlike a particle filter it has no place that it has given up before. The
/// lattice of all poses is weighed by the scans rigidly joined by odometry; then the scans of each
/// candidate are aligned with the map one by one, as far as odometry may err (align_paths).
///
/// Whether one place explains the scans better than another is a test between two models that are
/// both a little wrong, as maps are (vuong_statistic): a place that is better in few sectors by
/// much, as by an error of the map, is so not much more probable than the other.
class PlaceSearch {
 public:
  /// The model outlives this. Throws std::invalid_argument for settings that are not positive.
  explicit PlaceSearch(ObservationModel& model, const PlaceSearchParams& params = {});

  /// One from the same spot as the newest takes its place, since both err alike.
  void add(StopScan scan);
  /// Forgets all scans but so many of the newest, and what was heard on the way to the oldest of
  /// these.
  void keep_newest(std::size_t scans);
  std::size_t scans() const { return scans_.size(); }

  /// The places that so many of the newest scans speak for, the likeliest first, each once; that of
  /// `T_map_believed`, at the newest scan, is marked among them whatever its likelihood is. Empty
  /// without a reading or a floor.
  std::vector<FoundPlace> search(std::size_t newest,
                                 const std::optional<geometry::Pose2>& T_map_believed = {});

  bool is_same_place(const geometry::Pose2& one, const geometry::Pose2& other) const;

 private:
  struct Candidate {
    FoundPlace place;
    std::vector<double> sectors;  ///< Of each, the mean log-likelihood of a reading.
  };

  std::vector<geometry::Pose2> likeliest_of_lattice();
  geometry::Pose2 refined(geometry::Pose2 T_map_robot);
  /// The likeliest first.
  std::vector<Candidate> each_once(std::vector<Candidate> candidates) const;
  std::vector<FoundPlace> compared(const std::vector<Candidate>& candidates) const;

  ObservationModel& model_;
  PlaceSearchParams params_;
  Particles lattice_;            ///< Made on first use.
  std::vector<StopScan> scans_;  ///< The newest first.
};

}  // namespace echomap::localization

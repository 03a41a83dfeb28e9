// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/localization/observation_model.hpp"
#include "host/localization/particles.hpp"

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
  /// Readings of one scan are compared by sectors of so many to a turn; neighbouring sectors err
  /// together, so that only this share of them counts.
  std::size_t sectors = 6;
  double independent_share = 0.8;
};

/// A place from which a robot may have heard what it heard.
struct FoundPlace {
  geometry::Pose2 T_map_robot;  ///< At the newest scan.
  /// Mean over the readings, natural logarithm.
  double log_likelihood = 0.0;
  /// How probable it is against the place with the greatest likelihood, which has 1. Above 1 where
  /// it is better in most sectors although not on average.
  double odds = 1.0;
  bool is_believed = false;  ///< It is the place that the caller believes.
};

/// Looks for a robot in a whole map by its last scans together, rigidly joined by odometry: what
/// one scan cannot tell apart, several often can. Unlike a particle filter it has no place that it
/// has given up before.
///
/// Whether one place explains the scans better than another is a test between two models that are
/// both a little wrong, as maps are (Vuong 1989): the differences of log-likelihood, sector by
/// sector, are averaged and divided by the deviation of that average. A place that is better in few
/// sectors by much, as by an error of the map, is so not much more probable than the other.
class PlaceSearch {
 public:
  /// The model outlives this. Throws std::invalid_argument for settings that are not positive.
  explicit PlaceSearch(ObservationModel& model, const PlaceSearchParams& params = {});

  /// The readings of a scan, as from where the robot is now. One from the same spot as the newest
  /// takes its place: both err alike.
  void add(const geometry::Pose2& T_odom_robot, std::span<const RangeReading> readings);
  /// Forgets all scans but so many of the newest.
  void keep_newest(std::size_t scans);
  std::size_t scans() const { return scans_.size(); }

  /// The places that so many of the newest scans speak for, the likeliest first, each once; that of
  /// `T_map_believed`, at the newest scan, is marked among them whatever its likelihood is. Empty
  /// without a reading or a floor.
  std::vector<FoundPlace> search(std::size_t newest,
                                 const std::optional<geometry::Pose2>& T_map_believed = {});

  bool is_same_place(const geometry::Pose2& one, const geometry::Pose2& other) const;

 private:
  struct Scan {
    geometry::Pose2 T_odom_robot;
    std::vector<RangeReading> readings;
  };
  using Sector = std::vector<RangeReading>;

  /// From the newest place of the robot.
  std::vector<RangeReading> joined(std::size_t newest) const;
  std::vector<Sector> sectors_of(std::size_t newest) const;
  /// Sets the logarithms of the likelihood of what the model observed.
  void weigh(Particles& particles);
  std::vector<geometry::Pose2> likeliest_of_lattice();
  FoundPlace refined(geometry::Pose2 T_map_robot);
  std::vector<FoundPlace> each_once(std::vector<FoundPlace> places) const;
  void compare(std::span<const Sector> sectors, std::vector<FoundPlace>& places);

  ObservationModel& model_;
  PlaceSearchParams params_;
  Particles lattice_;  ///< Made on first use.
  std::deque<Scan> scans_;
};

}  // namespace echomap::localization

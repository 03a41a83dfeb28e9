// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::models {

/// How well a local map, made of one look around, agrees with the map of a room: the measurement
/// model of Mahmood and Ridao 2017, section 3.3, which is that of Thrun, Burgard and Fox 2005,
/// section 6.5. Occupancies are within [0, 1]; cells are those that the look has said something of.
class MapCorrelation {
 public:
  /// The occupancies of one cell in both maps.
  void add(double map, double local) {
    ++cells_;
    both_ += map + local;
    map_squares_ += map * map;
    local_squares_ += local * local;
    products_ += map * local;
    map_ += map;
  }

  /// rho of equation 6.36, around the mean of both maps together (6.35). Maps that are alike but
  /// have no contrast, as on an empty floor, agree fully: 1; so do no cells at all.
  double value() const;

 private:
  double cells_ = 0.0;
  double both_ = 0.0;
  double map_ = 0.0;
  double map_squares_ = 0.0;
  double local_squares_ = 0.0;
  double products_ = 0.0;
};

/// What of the correlation counts.
struct CorrelationParams {
  /// The least likelihood; ours, chosen on the simulated e-puck's field. The book has 0 (equation
  /// 6.37), by which one bad look would kill every particle.
  double least = 0.3;
};

/// p(z | x) = max(rho, least), after equation 6.37. Throws std::invalid_argument for a least that
/// is not within (0, 1].
class CorrelationLikelihood {
 public:
  explicit CorrelationLikelihood(const CorrelationParams& params = {});

  double likelihood(const MapCorrelation& correlation) const;

 private:
  CorrelationParams params_;
};

}  // namespace echomap::models

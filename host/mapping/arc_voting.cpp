// SPDX-License-Identifier: MIT
#include "host/mapping/arc_voting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include <Eigen/LU>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

/// Of the tables: whether it is the one of walls, and its two indices.
using Cell = std::array<int, 3>;

constexpr int kFitRounds = 4;

void check(const ArcVotingParams& params) {
  for (const double value : {params.beam_half_angle_rad,
                             params.bearing_step_rad,
                             params.distance_step_m,
                             params.range_tolerance_m,
                             params.range_sd_m,
                             params.bearing_sd_rad}) {
    if (!(value > 0.0)) {
      throw std::invalid_argument("arc voting: angles, steps and deviations must be above 0");
    }
  }
}

int index_of(double value, double step) { return static_cast<int>(std::lround(value / step)); }

/// Both tables: which returns have voted for a cell.
class VotingTables {
 public:
  VotingTables(const std::vector<PlacedReading>& readings, const ArcVotingParams& params)
      : params_(params),
        turns_(std::max(index_of(2.0 * std::numbers::pi, params.bearing_step_rad), 8)),
        turn_rad_(2.0 * std::numbers::pi / turns_),
        cells_of_(readings.size()) {
    for (std::size_t i = 0; i < readings.size(); ++i) {
      if (readings[i].range_m) {
        vote(i, readings[i]);
      }
    }
  }

  /// The cell with the most votes; of equals the first wall. Empty below `least` votes.
  std::optional<Cell> best(std::size_t least) const {
    std::optional<Cell> best;
    for (const auto& [cell, voters] : voters_of_) {
      if (voters.size() >= least + (best ? 1 : 0)) {
        best = cell;
        least = voters.size();
      }
    }
    return best;
  }

  SonarFeature feature_of(const Cell& cell) const {
    const auto [is_post, first, second] = cell;
    const double first_step = is_post != 0 ? params_.distance_step_m : turn_rad_;
    return {is_post == 0, {first * first_step, second * params_.distance_step_m}};
  }

  /// Takes back all votes of a return.
  void withdraw(std::size_t reading) {
    for (const Cell& cell : cells_of_[reading]) {
      const auto entry = voters_of_.find(cell);
      if (entry != voters_of_.end()) {
        entry->second.erase(reading);
      }
    }
  }
  /// Takes a cell out of the vote.
  void drop(const Cell& cell) { voters_of_.erase(cell); }

 private:
  /// One vote a cell, however long the arc is in it.
  void add(std::size_t reading, const Cell& cell) {
    if (voters_of_[cell].insert(reading).second) {
      cells_of_[reading].push_back(cell);
    }
  }

  void vote(std::size_t index, const PlacedReading& reading) {
    const Eigen::Vector2d& place_m = reading.T_map_sonar.position_m();
    const double axis_rad = reading.T_map_sonar.heading_rad();
    const double half_rad = params_.beam_half_angle_rad;
    const double range_m = *reading.range_m;
    for (int i = index_of(axis_rad - half_rad, turn_rad_);
         i <= index_of(axis_rad + half_rad, turn_rad_);
         ++i) {
      const Eigen::Vector2d normal = geometry::unit_vector(i * turn_rad_);
      const double offset_m = normal.dot(place_m) + range_m;
      add(index, {0, (i % turns_ + turns_) % turns_, index_of(offset_m, params_.distance_step_m)});
    }
    const double step_rad = 0.5 * params_.distance_step_m / std::max(range_m, 0.1);
    for (double off_rad = -half_rad; off_rad <= half_rad; off_rad += step_rad) {
      const Eigen::Vector2d post_m = place_m + range_m * geometry::unit_vector(axis_rad + off_rad);
      add(index,
          {1,
           index_of(post_m.x(), params_.distance_step_m),
           index_of(post_m.y(), params_.distance_step_m)});
    }
  }

  ArcVotingParams params_;
  /// A whole number of cells goes around.
  int turns_;
  double turn_rad_;
  std::map<Cell, std::set<std::size_t>> voters_of_;
  std::vector<std::vector<Cell>> cells_of_;
};

/// The returns that are still free.
using FreeReadings = std::vector<bool>;

std::vector<std::size_t> supporters_of(const SonarFeature& feature,
                                       const std::vector<PlacedReading>& readings,
                                       const FreeReadings& is_free,
                                       const ArcVotingParams& params) {
  std::vector<std::size_t> supporters;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (!is_free[i]) {
      continue;
    }
    const geometry::Pose2& T_map_sonar = readings[i].T_map_sonar;
    const FeatureView view = view_from(T_map_sonar.position_m(), feature);
    const double off_axis_rad =
        geometry::angle_between(T_map_sonar.heading_rad(), view.bearing_rad);
    if (std::abs(view.range_m - *readings[i].range_m) <= params.range_tolerance_m &&
        std::abs(off_axis_rad) <= params.beam_half_angle_rad + params.bearing_step_rad) {
      supporters.push_back(i);
    }
  }
  return supporters;
}

/// Gauss and Newton: one step towards what the supporters have heard.
VotedFeature fitted(VotedFeature voted,
                    const std::vector<PlacedReading>& readings,
                    const ArcVotingParams& params) {
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  Eigen::Vector2d pull = Eigen::Vector2d::Zero();
  const Eigen::DiagonalMatrix<double, 2> weight(
      1.0 / (params.bearing_sd_rad * params.bearing_sd_rad),
      1.0 / (params.range_sd_m * params.range_sd_m));
  for (const std::size_t i : voted.supporters) {
    const geometry::Pose2& T_map_sonar = readings[i].T_map_sonar;
    const FeatureView view = view_from(T_map_sonar.position_m(), voted.feature);
    const Eigen::Vector2d off(geometry::angle_between(view.bearing_rad, T_map_sonar.heading_rad()),
                              *readings[i].range_m - view.range_m);
    information += view.jacobian.transpose() * weight * view.jacobian;
    pull += view.jacobian.transpose() * weight * off;
  }
  voted.covariance = information.inverse();
  voted.feature.parameters += voted.covariance * pull;
  return voted;
}

std::size_t places_of(const std::vector<std::size_t>& supporters,
                      const std::vector<PlacedReading>& readings) {
  std::set<std::pair<double, double>> places;
  for (const std::size_t i : supporters) {
    const Eigen::Vector2d& place_m = readings[i].T_map_robot.position_m();
    places.emplace(place_m.x(), place_m.y());
  }
  return places.size();
}

std::optional<VotedFeature> elected(const SonarFeature& candidate,
                                    const std::vector<PlacedReading>& readings,
                                    const FreeReadings& is_free,
                                    const ArcVotingParams& params) {
  VotedFeature voted;
  voted.feature = candidate;
  for (int round = 0; round < kFitRounds; ++round) {
    voted.supporters = supporters_of(voted.feature, readings, is_free, params);
    if (voted.supporters.size() < params.least_votes ||
        places_of(voted.supporters, readings) < params.least_places) {
      return std::nullopt;
    }
    voted = fitted(std::move(voted), readings, params);
  }
  if (voted.feature.is_wall) {
    voted.feature.parameters.x() = geometry::wrap_angle(voted.feature.parameters.x());
  }
  return voted;
}

}  // namespace

std::vector<VotedFeature> vote_for_features(const std::vector<PlacedReading>& readings,
                                            const ArcVotingParams& params) {
  check(params);
  VotingTables tables(readings, params);
  FreeReadings is_free(readings.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    is_free[i] = readings[i].range_m.has_value();
  }
  std::vector<VotedFeature> features;
  while (const auto cell = tables.best(std::max<std::size_t>(params.least_votes / 2, 1))) {
    tables.drop(*cell);
    const auto voted = elected(tables.feature_of(*cell), readings, is_free, params);
    if (!voted) {
      continue;
    }
    for (const std::size_t i : voted->supporters) {
      is_free[i] = false;
      tables.withdraw(i);
    }
    features.push_back(*voted);
  }
  return features;
}

}  // namespace echomap::mapping

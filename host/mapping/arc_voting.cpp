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

/// A reading that something answered.
struct Return {
  std::size_t reading = 0;  ///< Its index among all.
  Eigen::Vector2d robot_m = Eigen::Vector2d::Zero();
  geometry::Pose2 T_map_sonar;
  double range_m = 0.0;
};

std::vector<Return> returns_of(const std::vector<PlacedReading>& readings) {
  std::vector<Return> returns;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const PlacedReading& reading = readings[i];
    if (reading.range_m) {
      returns.push_back(
          {i, reading.T_map_robot.position_m(), reading.T_map_sonar, *reading.range_m});
    }
  }
  return returns;
}

int index_of(double value, double step) { return static_cast<int>(std::lround(value / step)); }

/// Both tables: which returns have voted for a cell.
class VotingTables {
 public:
  VotingTables(const std::vector<Return>& returns, const ArcVotingParams& params)
      : params_(params),
        turns_(std::max(index_of(2.0 * std::numbers::pi, params.bearing_step_rad), 8)),
        turn_rad_(2.0 * std::numbers::pi / turns_),
        cells_of_(returns.size()) {
    for (std::size_t i = 0; i < returns.size(); ++i) {
      vote(i, returns[i]);
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
  void withdraw(std::size_t voter) {
    for (const Cell& cell : cells_of_[voter]) {
      const auto entry = voters_of_.find(cell);
      if (entry != voters_of_.end()) {
        entry->second.erase(voter);
      }
    }
  }
  /// Takes a cell out of the vote.
  void drop(const Cell& cell) { voters_of_.erase(cell); }

 private:
  /// One vote a cell, however long the arc is in it.
  void add(std::size_t voter, const Cell& cell) {
    if (voters_of_[cell].insert(voter).second) {
      cells_of_[voter].push_back(cell);
    }
  }

  void vote(std::size_t index, const Return& heard) {
    const Eigen::Vector2d& place_m = heard.T_map_sonar.position_m();
    const double axis_rad = heard.T_map_sonar.heading_rad();
    const double half_rad = params_.beam_half_angle_rad;
    const double range_m = heard.range_m;
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
using FreeReturns = std::vector<bool>;

std::vector<std::size_t> supporters_of(const SonarFeature& feature,
                                       const std::vector<Return>& returns,
                                       const FreeReturns& is_free,
                                       const ArcVotingParams& params) {
  std::vector<std::size_t> supporters;
  for (std::size_t i = 0; i < returns.size(); ++i) {
    if (!is_free[i]) {
      continue;
    }
    const geometry::Pose2& T_map_sonar = returns[i].T_map_sonar;
    const FeatureView view = view_from(T_map_sonar.position_m(), feature);
    const double off_axis_rad =
        geometry::angle_between(T_map_sonar.heading_rad(), view.bearing_rad);
    if (std::abs(view.range_m - returns[i].range_m) <= params.range_tolerance_m &&
        std::abs(off_axis_rad) <= params.beam_half_angle_rad + params.bearing_step_rad) {
      supporters.push_back(i);
    }
  }
  return supporters;
}

/// Gauss and Newton: one step towards what the supporters have heard.
VotedFeature fitted(VotedFeature voted,
                    const std::vector<Return>& returns,
                    const ArcVotingParams& params) {
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  Eigen::Vector2d pull = Eigen::Vector2d::Zero();
  const Eigen::DiagonalMatrix<double, 2> weight(
      1.0 / (params.bearing_sd_rad * params.bearing_sd_rad),
      1.0 / (params.range_sd_m * params.range_sd_m));
  for (const std::size_t i : voted.supporters) {
    const geometry::Pose2& T_map_sonar = returns[i].T_map_sonar;
    const FeatureView view = view_from(T_map_sonar.position_m(), voted.feature);
    const Eigen::Vector2d off(geometry::angle_between(view.bearing_rad, T_map_sonar.heading_rad()),
                              returns[i].range_m - view.range_m);
    information += view.jacobian.transpose() * weight * view.jacobian;
    pull += view.jacobian.transpose() * weight * off;
  }
  voted.covariance = information.inverse();
  voted.feature.parameters += voted.covariance * pull;
  return voted;
}

std::size_t places_of(const std::vector<std::size_t>& supporters,
                      const std::vector<Return>& returns) {
  std::set<std::pair<double, double>> places;
  for (const std::size_t i : supporters) {
    const Eigen::Vector2d& place_m = returns[i].robot_m;
    places.emplace(place_m.x(), place_m.y());
  }
  return places.size();
}

std::optional<VotedFeature> elected(const SonarFeature& candidate,
                                    const std::vector<Return>& returns,
                                    const FreeReturns& is_free,
                                    const ArcVotingParams& params) {
  VotedFeature voted;
  voted.feature = candidate;
  for (int round = 0; round < kFitRounds; ++round) {
    voted.supporters = supporters_of(voted.feature, returns, is_free, params);
    if (voted.supporters.size() < params.least_votes ||
        places_of(voted.supporters, returns) < params.least_places) {
      return std::nullopt;
    }
    voted = fitted(std::move(voted), returns, params);
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
  const std::vector<Return> returns = returns_of(readings);
  VotingTables tables(returns, params);
  FreeReturns is_free(returns.size(), true);
  std::vector<VotedFeature> features;
  while (const auto cell = tables.best(std::max<std::size_t>(params.least_votes / 2, 1))) {
    tables.drop(*cell);
    auto voted = elected(tables.feature_of(*cell), returns, is_free, params);
    if (!voted) {
      continue;
    }
    for (std::size_t& supporter : voted->supporters) {
      is_free[supporter] = false;
      tables.withdraw(supporter);
      supporter = returns[supporter].reading;
    }
    features.push_back(*voted);
  }
  return features;
}

}  // namespace echomap::mapping

// SPDX-License-Identifier: MIT
#include "host/source_search/dwell_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "host/exploration/path_planner.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::source_search {

using exploration::CostGrid;

namespace {

/// So near to it a place is the goal that the robot is under way to.
constexpr double kSameGoalM = 0.3;
/// Around the most probable place finer places are tried, so far off, once it is so probable.
constexpr double kFineProbability = 0.05;
constexpr double kFineRadiiM[] = {0.0, 0.2, 0.45};
constexpr int kFineBearings = 8;
constexpr double kFineReachM = 2.5;
constexpr double kFineStepM = 0.3;

/// The ways of a tree, gone through depth first, so that each is measured once.
class PathSearch {
 public:
  PathSearch(const DwellChoiceParams& params,
             const InformationGain& gain,
             const DwellLattice& lattice,
             const DwellLattice::Tree& tree,
             PairDistances others)
      : params_(params),
        gain_(gain),
        lattice_(lattice),
        tree_(tree),
        others_(std::move(others)),
        before_(gain.expected_log_probability(others_)),
        children_(tree.parent.size()) {
    for (const std::uint32_t place : tree.order) {
      if (time_s(place) > params.max_path_s) {
        break;
      }
      const std::int32_t parent = tree.parent[place];
      (parent < 0 ? roots_ : children_[static_cast<std::size_t>(parent)]).push_back(place);
    }
  }

  void go_everywhere() {
    for (const std::uint32_t root : roots_) {
      go(root, others_, 0.0);
    }
  }

  /// Straight there, where the robot counts in steps.
  void go_straight(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
    const double length_m = (to_m - from_m).norm();
    const int steps = std::max(1, static_cast<int>(std::ceil(length_m / kFineStepM)));
    PairDistances distances = others_;
    readings_.clear();
    for (int i = 0; i < steps && length_m > 0.0; ++i) {
      const double share = (i + 0.5) / steps;
      readings_.push_back(
          {from_m + share * (to_m - from_m), length_m / params_.speed_m_per_s / steps});
      gain_.add(readings_.back(), distances);
    }
    consider(to_m, distances, length_m / params_.speed_m_per_s);
  }

  void set_current(const Eigen::Vector2d& goal_m) { current_m_ = goal_m; }
  /// The best one, or the way to the current goal where that is hardly worse.
  std::optional<DwellPlan> result() const {
    const bool is_kept =
        current_ && best_ && params_.better * current_->gain_per_s >= best_->gain_per_s;
    return is_kept ? current_ : best_;
  }

 private:
  double time_s(std::uint32_t place) const {
    return tree_.distance_m[place] / params_.speed_m_per_s;
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as a way has places
  void go(std::uint32_t place, const PairDistances& before, double time_before_s) {
    PairDistances distances = before;
    const Eigen::Vector2d& at_m = lattice_.places_m()[place];
    readings_.push_back({at_m, time_s(place) - time_before_s});
    gain_.add(readings_.back(), distances);
    consider(at_m, distances, time_s(place));
    for (const std::uint32_t child : children_[place]) {
      go(child, distances, time_s(place));
    }
    readings_.pop_back();
  }

  void consider(const Eigen::Vector2d& at_m, PairDistances distances, double time_s) {
    take(at_m, 0.0, gain_.expected_log_probability(distances) - before_, time_s);
    gain_.add({at_m, params_.dwell_s}, distances);
    take(at_m,
         params_.dwell_s,
         gain_.expected_log_probability(distances) - before_,
         time_s + params_.dwell_s);
  }

  void take(const Eigen::Vector2d& at_m, double dwell_s, double gain, double time_s) {
    const DwellPlan plan{at_m, dwell_s, {}, gain, time_s, gain / (time_s + params_.overhead_s)};
    const bool is_current = current_m_ && (at_m - *current_m_).norm() < kSameGoalM;
    for (std::optional<DwellPlan>* of : {&best_, &current_}) {
      if ((of == &best_ || is_current) && time_s > 0.0 &&
          (!*of || plan.gain_per_s > (*of)->gain_per_s)) {
        *of = plan;
        (*of)->readings = readings_;
        (*of)->readings.push_back({at_m, dwell_s});
      }
    }
  }

  const DwellChoiceParams& params_;
  const InformationGain& gain_;
  const DwellLattice& lattice_;
  const DwellLattice::Tree& tree_;
  PairDistances others_;
  double before_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<std::uint32_t> roots_;
  std::optional<Eigen::Vector2d> current_m_;
  std::vector<PlannedDwell> readings_;  ///< Of the way that is gone through.
  std::optional<DwellPlan> best_;
  std::optional<DwellPlan> current_;
};

/// Places around the most probable one that the robot can drive to straight ahead.
std::vector<Eigen::Vector2d> fine_places_m(const SourceBelief& belief,
                                           const CostGrid& costs,
                                           const Eigen::Vector2d& from_m) {
  const SourceEstimate& estimate = belief.estimate();
  std::vector<Eigen::Vector2d> places_m{from_m};
  if (estimate.within_probability < kFineProbability ||
      (estimate.best_m - from_m).norm() > kFineReachM) {
    return places_m;
  }
  for (const double radius_m : kFineRadiiM) {
    for (int i = 0; i < (radius_m > 0.0 ? kFineBearings : 1); ++i) {
      const double bearing_rad = 2.0 * std::numbers::pi * i / kFineBearings;
      const Eigen::Vector2d at_m = estimate.best_m + radius_m * geometry::unit_vector(bearing_rad);
      if (exploration::line_cost_m(costs, costs.cell_at(from_m), costs.cell_at(at_m))) {
        places_m.push_back(at_m);
      }
    }
  }
  return places_m;
}

}  // namespace

DwellChoice::DwellChoice(const DwellChoiceParams& params) : params_(params) {
  geometry::ParameterValidator("dwell choice")
      .positive("samples", params.samples)
      .positive_finite("spacing_m", params.spacing_m)
      .positive_finite("max_path_s", params.max_path_s)
      .positive_finite("dwell_s", params.dwell_s)
      .positive_finite("speed_m_per_s", params.speed_m_per_s)
      .nonnegative_finite("overhead_s", params.overhead_s)
      .at_least("better", params.better, 1.0);
}

std::optional<DwellPlan> DwellChoice::choose(const SourceBelief& belief,
                                             const CostGrid& costs,
                                             const DwellLattice& lattice,
                                             const Eigen::Vector2d& from_m,
                                             std::span<const PlannedDwell> others,
                                             std::optional<Eigen::Vector2d> current_m,
                                             double offset) const {
  const InformationGain gain(belief, belief.sample(params_.samples, offset));
  PairDistances distances = gain.no_reading();
  for (const PlannedDwell& dwell : others) {
    gain.add(dwell, distances);
  }
  const DwellLattice::Tree tree = lattice.tree_from(costs, from_m);
  PathSearch search(params_, gain, lattice, tree, std::move(distances));
  if (current_m) {
    search.set_current(*current_m);
  }
  search.go_everywhere();
  for (const Eigen::Vector2d& place_m : fine_places_m(belief, costs, from_m)) {
    search.go_straight(from_m, place_m);
  }
  return search.result();
}

}  // namespace echomap::source_search

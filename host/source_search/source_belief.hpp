// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "host/mapping/cell_field.hpp"
#include "host/source_search/hypothesis_grid.hpp"
#include "host/source_search/source_estimate.hpp"

namespace echomap::source_search {

/// Values without another source are ours, chosen in simulation.
struct SourceBeliefParams {
  HypothesisGridParams grid;
  /// Prior probability that there is no source as strong as the weakest considered.
  double none_prior = 0.5;
  /// A source is found within this distance with this probability; that there is none is claimed
  /// with the same.
  double found_radius_m = 0.2;
  double claim_probability = 0.95;
  /// Smallest probability of the source within that radius of where it truly is, the error of the
  /// map included: on a map that is less certain nothing is claimed.
  double min_true_probability = 0.5;
  /// On an unfinished map, a place is claimed only once this many pulses of its source are expected
  /// to have been read within `confirm_m`, in sight of it. Without a source there, their absence is
  /// noticed in 95 % of cases.
  double confirm_m = 0.5;
  double confirm_pulses = 3.0;
  /// A square that holds more of the probability than this is split.
  double split_probability = 0.004;
};

/// One hypothesis of where the source is, if there is any.
struct SourceHypothesis {
  double probability = 0.0;             ///< Probability of all that it represents.
  std::optional<Eigen::Vector2d> at_m;  ///< Empty for no source.
  double edge_m = 0.0;                  ///< Edge of the square that it represents.
  double strength = 0.0;
  double background = 0.0;
  Shielding shielding;
};

/// Posterior of the place and strength of one source, and of whether there is any, given all
/// readings: Bayes' rule on a grid, exact up to the nodes, with the background, the strength and
/// the shielding of walls marginalized.
class SourceBelief {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  SourceBelief(const SourceBeliefParams& params, const SourceFloor& floor);

  /// Adds readings, of this robot or of others.
  void add(std::span<const FieldReading> readings);
  /// Starts again on another floor, with these readings in place of those so far.
  void rebuild(const SourceFloor& floor, std::span<const FieldReading> readings);

  const SourceEstimate& estimate() const { return estimate_; }
  /// Samples that represent the posterior: that there is none or that it is on unseen floor, which
  /// no reading can distinguish, and `count` places, spread evenly over the probability; `offset`
  /// from 0 to 1 chooses which.
  std::vector<SourceHypothesis> sample(std::size_t count, double offset) const;
  /// The probability of each cell to hold the source, in cells of the smallest square.
  mapping::CellField place_probability() const;

  /// Whether a reading there confirms, or refutes, the most probable place.
  bool confirms(const Eigen::Vector2d& at_m) const;

  const HypothesisGrid& grid() const { return grid_; }
  const SourceBeliefParams& params() const { return params_; }

 private:
  void update();
  void set_marginals();
  bool refine_places();
  bool refine_backgrounds();
  void set_estimate();
  bool is_confirmed() const;
  double strength_slack() const;
  LogEstimate strength_at(const Eigen::Vector2d& at_m) const;
  std::vector<LeafIndex> leaves() const;
  std::vector<LeafIndex> leaves_in_order() const;

  SourceBeliefParams params_;
  HypothesisGrid grid_;
  double unseen_m2_;
  bool is_in_the_making_;
  double position_stddev_m_;
  /// Probability that the source is there, by block and lane.
  std::vector<std::array<double, kLanes>> place_;
  std::vector<double> background_;  ///< By node of the grid.
  double readings_at_background_choice_ = 6.0;
  SourceEstimate estimate_;
};

}  // namespace echomap::source_search

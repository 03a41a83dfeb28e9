// SPDX-License-Identifier: MIT
#include "host/source_search/source_belief.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/square.hpp"
#include "host/source_search/block_posterior.hpp"
#include "host/source_search/probable_disc.hpp"

namespace echomap::source_search {

using geometry::CellIndex;
using geometry::square;
using mapping::CellBounds;
using mapping::CellField;

namespace {

/// What is so much less likely, by logarithm, does not count.
constexpr double kNegligible = 25.0;
/// Backgrounds are held to so many standard deviations to both sides of their mean.
constexpr double kBackgroundStddevs = 5.0;
/// A posterior whose first or last background is more probable than this is cut off.
constexpr double kMaxEndProbability = 0.02;
/// The spread of a posterior that falls between two nodes is no less than so much of their
/// distance.
constexpr double kMinSpreadNodes = 0.4;
/// Backgrounds are chosen again when there are this many times the readings of the last time.
constexpr double kMoreReadings = 1.5;
constexpr double kMinReadings = 6.0;
constexpr int kMaxPasses = 6;
/// Logarithms of backgrounds that differ by no more are the same.
constexpr double kSameLog = 1e-3;
/// Of a disc that holds the source.
constexpr double kRegionProbability = 0.95;
/// The golden ratio: its multiples, modulo 1, are spread evenly.
constexpr double kGolden = 0.6180339887498949;

void validate_belief(const SourceBeliefParams& params) {
  geometry::ParameterValidator("source belief")
      .above("none_prior", params.none_prior, 0.0)
      .below("none_prior", params.none_prior, 1.0)
      .positive_finite("found_radius_m", params.found_radius_m)
      .above("claim_probability", params.claim_probability, 0.5)
      .below("claim_probability", params.claim_probability, 1.0)
      .positive_finite("confirm_m", params.confirm_m)
      .within("min_true_probability", params.min_true_probability, 0.0, 1.0)
      .nonnegative_finite("confirm_pulses", params.confirm_pulses)
      .positive_finite("split_probability", params.split_probability);
}

double max_of(const LeafBlock& block) {
  const Lanes maxima = row_maxima(block.lanes(0), block.log_likelihood.size() / kLanes);
  return static_cast<double>(*std::max_element(maxima.begin(), maxima.end()));
}

/// Of a logarithm, by its mean and the mean of its square.
LogEstimate log_estimate(double mean, double mean_square) {
  return {std::exp(mean), std::sqrt(std::max(0.0, mean_square - square(mean)))};
}

/// Column and row of a point, interleaved: what is near in this order is near on the floor (Morton
/// 1966).
std::uint64_t morton_code(double x_m, double y_m) {
  const auto column = static_cast<std::uint32_t>(std::lround(x_m * 100.0) + (1 << 20));
  const auto row = static_cast<std::uint32_t>(std::lround(y_m * 100.0) + (1 << 20));
  std::uint64_t code = 0;
  for (std::uint32_t bit = 0; bit < 24; ++bit) {
    code |= static_cast<std::uint64_t>((column >> bit) & 1U) << (2 * bit);
    code |= static_cast<std::uint64_t>((row >> bit) & 1U) << (2 * bit + 1);
  }
  return code;
}

/// One of `shares` by a number from 0 to 1.
const NuisanceShare& chosen(const std::vector<NuisanceShare>& shares, double at) {
  double sum = 0.0;
  for (const NuisanceShare& share : shares) {
    sum += share.probability;
    if (sum > at) {
      return share;
    }
  }
  return shares.back();
}

}  // namespace

SourceBelief::SourceBelief(const SourceBeliefParams& params, const SourceFloor& floor)
    : params_((validate_belief(params), params)),
      grid_(params.grid, floor),
      unseen_m2_(floor.unseen_m2),
      is_in_the_making_(floor.is_in_the_making),
      position_stddev_m_(floor.position_stddev_m) {
  update();
}

void SourceBelief::add(std::span<const FieldReading> readings) {
  grid_.add(readings);
  update();
}

void SourceBelief::rebuild(const SourceFloor& floor, std::span<const FieldReading> readings) {
  grid_ = HypothesisGrid(params_.grid, floor);
  unseen_m2_ = floor.unseen_m2;
  is_in_the_making_ = floor.is_in_the_making;
  position_stddev_m_ = floor.position_stddev_m;
  readings_at_background_choice_ = kMinReadings;
  grid_.add(readings);
  update();
}

/// Refines squares and backgrounds until they are as fine as the posterior needs.
void SourceBelief::update() {
  set_marginals();
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    const bool are_backgrounds_other = refine_backgrounds();
    const bool are_places_other = refine_places();
    if (!are_backgrounds_other && !are_places_other) {
      break;
    }
    set_marginals();
  }
  set_estimate();
}

/// By how much a likelihood may be larger between nodes of the strength than at them.
double SourceBelief::strength_slack() const {
  const auto& strengths = grid_.nodes().strengths;
  const double step = std::log(static_cast<double>(strengths[1] / strengths[0]));
  double pulses = 0.0;
  for (const FieldReading& reading : grid_.readings()) {
    pulses += reading.value;
  }
  return 0.125 * square(step) * pulses;
}

/// A source on unseen floor adds nothing to any reading, as none does.
void SourceBelief::set_marginals() {
  const std::vector<float> background_masses = source_search::background_masses(grid_);
  std::vector<double> maxima;
  double best = *std::max_element(grid_.none().begin(), grid_.none().end());
  for (const LeafBlock& block : grid_.blocks()) {
    maxima.push_back(max_of(block));
    best = std::max(best, maxima.back());
  }
  const double least = best - kNegligible - strength_slack();
  const double density = (1.0 - params_.none_prior) / (grid_.area_m2() + unseen_m2_);
  const double silent_prior = params_.none_prior + density * unseen_m2_;
  double total = 0.0;
  background_.assign(grid_.none().size(), 0.0);
  for (std::size_t b = 0; b < background_.size(); ++b) {
    background_[b] =
        silent_prior * static_cast<double>(background_masses[b]) * std::exp(grid_.none()[b] - best);
    total += background_[b];
  }
  const double silent = total;
  place_.assign(grid_.blocks().size(), {});
  for (std::size_t i = 0; i < place_.size(); ++i) {
    if (maxima[i] < least) {
      continue;
    }
    const auto posterior = posterior_of(grid_, grid_.blocks()[i], density, best);
    place_[i] = posterior.place;
    for (std::size_t b = 0; b < background_.size(); ++b) {
      background_[b] += posterior.background[b];
      total += posterior.background[b];
    }
  }
  for (auto& block : place_) {
    for (double& probability : block) {
      probability /= total;
    }
  }
  for (double& probability : background_) {
    probability /= total;
  }
  estimate_.none_probability = silent / total * params_.none_prior / silent_prior;
  estimate_.unseen_probability = silent / total - estimate_.none_probability;
  double mean = 0.0;
  double mean_square = 0.0;
  for (std::size_t b = 0; b < background_.size(); ++b) {
    const double log_background = std::log(static_cast<double>(grid_.nodes().backgrounds[b]));
    mean += background_[b] * log_background;
    mean_square += background_[b] * square(log_background);
  }
  estimate_.background = log_estimate(mean, mean_square);
}

bool SourceBelief::refine_places() {
  std::vector<LeafIndex> coarse;
  for (std::size_t block = 0; block < place_.size(); ++block) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (place_[block][lane] > params_.split_probability && grid_.is_splittable({block, lane})) {
        coarse.push_back({block, lane});
      }
    }
  }
  grid_.split(coarse);
  return !coarse.empty();
}

/// Backgrounds are evenly spaced over where the posterior is. A narrower posterior takes more
/// readings, a wider one is rare: it is seldom that all likelihoods have to be recomputed.
bool SourceBelief::refine_backgrounds() {
  const FieldParams& field = grid_.params().field;
  const double first = std::log(static_cast<double>(grid_.nodes().backgrounds.front()));
  const double last = std::log(static_cast<double>(grid_.nodes().backgrounds.back()));
  const double node = (last - first) / static_cast<double>(background_.size() - 1);
  const double reach =
      kBackgroundStddevs * std::max(estimate_.background.log_stddev, kMinSpreadNodes * node);
  const double middle = std::log(estimate_.background.median);
  double low = std::max(std::log(field.min_background), middle - reach);
  double high = std::min(std::log(field.max_background), middle + reach);
  const auto readings = static_cast<double>(grid_.readings().size());
  const bool is_cut_off = (background_.front() > kMaxEndProbability && low < first - kSameLog) ||
                          (background_.back() > kMaxEndProbability && high > last + kSameLog);
  if (is_cut_off) {
    low = std::min(low, first);
    high = std::max(high, last);
  } else if (readings < kMoreReadings * readings_at_background_choice_) {
    return false;
  }
  readings_at_background_choice_ = std::max(readings, kMinReadings);
  grid_.set_background_range(std::exp(low), std::exp(high));
  return true;
}

bool SourceBelief::confirms(const Eigen::Vector2d& at_m) const {
  const Eigen::Vector2d& place_m = estimate_.best_m;
  return (at_m - place_m).norm() <= params_.confirm_m &&
         is_in_sight(
             grid_.map(), at_m, place_m, grid_.params().solid_depth_m, params_.found_radius_m);
}

/// From afar, a place is determined by the shadows of the map's walls, which are as wrong as the
/// map is, for many readings alike. Beside the source only the distance counts.
bool SourceBelief::is_confirmed() const {
  double expected = 0.0;
  for (const FieldReading& reading : grid_.readings()) {
    if (confirms(reading.at_m)) {
      expected += estimate_.strength.median * reading.dwell_s *
                  grid_.response_at(reading, estimate_.best_m, 0.0, {}).response;
    }
  }
  return expected >= params_.confirm_pulses;
}

/// A claim is of the place against the map around it. How probably that is within the radius of
/// where the source truly is depends on the error of the map, and may be too little to claim.
void SourceBelief::set_estimate() {
  const CellField probability = place_probability();
  const ProbableDisc disc = most_probable_disc(probability, params_.found_radius_m);
  const CellField blurred = with_error(probability, position_stddev_m_);
  estimate_.best_m = disc.middle_m;
  estimate_.within_probability =
      std::min(sum_in_disc(blurred, disc.middle_m, params_.found_radius_m), 1.0);
  estimate_.radius_95_m = radius_with_share_m(blurred, disc.middle_m, kRegionProbability);
  estimate_.strength = strength_at(disc.middle_m);
  estimate_.verdict = SourceVerdict::kUndecided;
  const bool is_probable = disc.probability >= params_.claim_probability &&
                           estimate_.within_probability >= params_.min_true_probability;
  estimate_.is_to_confirm = is_probable && is_in_the_making_ && !is_confirmed();
  if (is_probable && !estimate_.is_to_confirm) {
    estimate_.verdict = SourceVerdict::kFound;
  } else if (estimate_.none_probability >= params_.claim_probability) {
    estimate_.verdict = SourceVerdict::kNone;
  }
}

/// Of the square that the point is in.
LogEstimate SourceBelief::strength_at(const Eigen::Vector2d& at_m) const {
  for (const LeafIndex& leaf : leaves()) {
    const LeafBlock& block = grid_.blocks()[leaf.block];
    const double half_m = 0.5 * block.edge_m[leaf.lane];
    if (std::abs(block.x_m[leaf.lane] - at_m.x()) > half_m ||
        std::abs(block.y_m[leaf.lane] - at_m.y()) > half_m) {
      continue;
    }
    double mean = 0.0;
    double mean_square = 0.0;
    for (const NuisanceShare& share : nuisances_of(grid_, leaf)) {
      mean += share.probability * std::log(share.strength);
      mean_square += share.probability * square(std::log(share.strength));
    }
    return log_estimate(mean, mean_square);
  }
  return {};
}

std::vector<LeafIndex> SourceBelief::leaves() const {
  std::vector<LeafIndex> leaves;
  for (std::size_t block = 0; block < place_.size(); ++block) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (grid_.blocks()[block].area_m2[lane] > 0.0) {
        leaves.push_back({block, lane});
      }
    }
  }
  return leaves;
}

CellField SourceBelief::place_probability() const {
  const mapping::RasterMap& map = grid_.map();
  const double resolution_m = grid_.params().min_leaf_m;
  const double margin_m = grid_.params().leaf_m;
  const Eigen::Vector2d size_m = map.resolution_m() * Eigen::Vector2d(map.columns(), map.rows());
  const CellField any({}, resolution_m);
  CellField field(
      CellBounds{any.cell_at(map.origin_m().array() - margin_m),
                 any.cell_at(map.origin_m() + size_m + Eigen::Vector2d::Constant(margin_m))},
      resolution_m);
  for (const LeafIndex& leaf : leaves()) {
    const LeafBlock& block = grid_.blocks()[leaf.block];
    const double edge_m = block.edge_m[leaf.lane];
    const auto side = static_cast<std::int32_t>(std::lround(edge_m / resolution_m));
    const Eigen::Vector2d low_m(block.x_m[leaf.lane] - 0.5 * (edge_m - resolution_m),
                                block.y_m[leaf.lane] - 0.5 * (edge_m - resolution_m));
    const CellIndex low = field.cell_at(low_m);
    const auto share = static_cast<float>(place_[leaf.block][leaf.lane] / (side * side));
    for (std::int32_t i = 0; i < side * side; ++i) {
      field[field.index({low.x + i % side, low.y + i / side})] += share;
    }
  }
  return field;
}

std::vector<SourceHypothesis> SourceBelief::sample(std::size_t count, double offset) const {
  const std::vector<LeafIndex> order = leaves_in_order();
  const double silent = estimate_.none_probability + estimate_.unseen_probability;
  std::vector<SourceHypothesis> hypotheses{
      {silent, std::nullopt, 0.0, 0.0, estimate_.background.median, {}}};
  if (order.empty()) {
    return hypotheses;
  }
  const double each = (1.0 - silent) / static_cast<double>(count);
  double sum = 0.0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < count; ++i) {
    while (next < order.size() && sum <= (static_cast<double>(i) + offset) * each) {
      sum += place_[order[next].block][order[next].lane];
      ++next;
    }
    const LeafIndex leaf = order[std::max<std::size_t>(next, 1) - 1];
    const LeafBlock& block = grid_.blocks()[leaf.block];
    const auto shares = nuisances_of(grid_, leaf);
    const double at = std::fmod(offset + static_cast<double>(i) * kGolden, 1.0);
    const NuisanceShare& share = chosen(shares, at);
    hypotheses.push_back({each,
                          Eigen::Vector2d(block.x_m[leaf.lane], block.y_m[leaf.lane]),
                          block.edge_m[leaf.lane],
                          share.strength,
                          share.background,
                          share.shielding});
  }
  return hypotheses;
}

/// Along a curve that fills the floor.
std::vector<LeafIndex> SourceBelief::leaves_in_order() const {
  std::vector<std::pair<std::uint64_t, LeafIndex>> coded;
  for (const LeafIndex& leaf : leaves()) {
    const LeafBlock& block = grid_.blocks()[leaf.block];
    coded.emplace_back(morton_code(block.x_m[leaf.lane], block.y_m[leaf.lane]), leaf);
  }
  std::sort(coded.begin(), coded.end(), [](const auto& one, const auto& other) {
    return one.first < other.first;
  });
  std::vector<LeafIndex> order;
  for (const auto& [code, leaf] : coded) {
    order.push_back(leaf);
  }
  return order;
}

}  // namespace echomap::source_search

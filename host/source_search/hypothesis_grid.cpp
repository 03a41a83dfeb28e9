// SPDX-License-Identifier: MIT
#include "host/source_search/hypothesis_grid.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/square.hpp"
#include "host/mapping/distance_field.hpp"

namespace echomap::source_search {

using exploration::CellValues;
using exploration::for_each_cell;
using geometry::CellIndex;
using geometry::square;
using mapping::CellState;
using mapping::RasterMap;

namespace {

/// Unknown cells that are less likely floor than this hold no source.
constexpr float kMinFloorShare = 0.02F;

void validate_grid(const HypothesisGridParams& params) {
  validate(params.field);
  geometry::ParameterValidator("hypothesis grid")
      .positive_finite("min_leaf_m", params.min_leaf_m)
      .finite("leaf_m", params.leaf_m)
      .at_least("leaf_m", params.leaf_m, params.min_leaf_m)
      .nonnegative_finite("merge_m", params.merge_m)
      .at_least("strength_nodes", params.strength_nodes, 4)
      .at_least("background_nodes", params.background_nodes, 2)
      .nonnegative_finite("unknown_reach_m", params.unknown_reach_m)
      .nonnegative_finite("hollow_m", params.hollow_m)
      .nonnegative_finite("solid_depth_m", params.solid_depth_m);
}

std::vector<float> geometric_range(double min, double max, std::size_t count) {
  std::vector<float> values;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    values.push_back(static_cast<float>(min * std::pow(max / min, share)));
  }
  return values;
}

std::int32_t cells_in(double length_m, const RasterMap& map) {
  return static_cast<std::int32_t>(length_m / map.resolution_m() + 1e-6);
}

CellValues<float> cells_of_source(const RasterMap& map,
                                  const CellValues<float>& floor_chance,
                                  const HypothesisGridParams& params) {
  const double depth_m = std::max(params.solid_depth_m, map.resolution_m());
  const mapping::DistanceField from_floor =
      distances_to_known_floor(map, depth_m + map.resolution_m());
  const double depth_cells = params.solid_depth_m / map.resolution_m() + 1e-6;
  CellValues<float> may_hold = floor_chance;
  for_each_cell(map, [&](CellIndex cell) {
    if (map.state(cell) == CellState::kOccupied && from_floor.distance_cells(cell) <= depth_cells) {
      may_hold[cell] = 1.0F;
    }
    if (may_hold[cell] < kMinFloorShare) {
      may_hold[cell] = 0.0F;
    }
  });
  return may_hold;
}

/// With unknown cells as air and, where any may be, as solid, each as likely.
std::vector<Shielding> shieldings_of(const FieldParams& field, bool has_unknown) {
  const double prior = 1.0 / static_cast<double>(field.attenuations_per_m.size());
  std::vector<Shielding> shieldings;
  for (const double attenuation_per_m : field.attenuations_per_m) {
    if (attenuation_per_m <= 0.0 || !has_unknown) {
      shieldings.push_back({attenuation_per_m, false, prior});
      continue;
    }
    shieldings.push_back({attenuation_per_m, false, 0.5 * prior});
    shieldings.push_back({attenuation_per_m, true, 0.5 * prior});
  }
  return shieldings;
}

double shielding_m(const CrossedLengths& crossed, const Shielding& shielding) {
  return crossed.solid_m + (shielding.is_unknown_solid ? crossed.unknown_m : 0.0);
}

/// The error of a place that is somewhere in a square, along an axis.
double square_variance_m2(double edge_m) { return square(edge_m) / 12.0; }

ReadingTerms terms_of(const FieldReading& reading, const FieldParams& params) {
  ReadingTerms terms;
  terms.value = static_cast<float>(reading.value);
  terms.background_variance = static_cast<float>(square(params.background_error));
  if (params.kind == SensorKind::kLevel) {
    terms.variance = static_cast<float>(square(params.level_stddev) / reading.dwell_s);
    return terms;
  }
  terms.dwell_s = static_cast<float>(reading.dwell_s);
  terms.saturated =
      reading.value > 0.0
          ? static_cast<float>(reading.value * std::log(reading.value) - reading.value)
          : 0.0F;
  return terms;
}

/// Two readings as one. Of levels `dwell_s` counts readings here.
FieldReading merged(const FieldReading& one, const FieldReading& other, SensorKind kind) {
  const double dwell_s = one.dwell_s + other.dwell_s;
  const double share = other.dwell_s / dwell_s;
  FieldReading both = one;
  both.at_m += share * (other.at_m - one.at_m);
  both.value = kind == SensorKind::kPulses ? one.value + other.value
                                           : one.value + share * (other.value - one.value);
  both.dwell_s = dwell_s;
  both.position_stddev_m = std::max(one.position_stddev_m, other.position_stddev_m);
  return both;
}

}  // namespace

HypothesisGrid::HypothesisGrid(const HypothesisGridParams& params, const SourceFloor& floor)
    : params_((validate_grid(params), params)),
      map_(floor.map),
      floor_chance_(unknown_reach(floor, cells_in(params.unknown_reach_m, floor.map)).share),
      may_hold_(cells_of_source(map_, floor_chance_, params)),
      solids_(map_, floor_chance_, params.hollow_m) {
  const FieldParams& field = params_.field;
  nodes_.strengths =
      geometric_range(field.min_strength, field.max_strength, params_.strength_nodes);
  nodes_.shieldings = shieldings_of(field, solids_.has_unknown());
  nodes_.backgrounds =
      geometric_range(field.min_background, field.max_background, params_.background_nodes);
  none_.assign(nodes_.backgrounds.size(), 0.0);
  append(initial_leaves());
}

std::vector<HypothesisGrid::Leaf> HypothesisGrid::initial_leaves() {
  const double edge_m = params_.leaf_m;
  const Eigen::Vector2d low_m = map_.origin_m();
  const Eigen::Vector2d high_m =
      low_m + map_.resolution_m() * Eigen::Vector2d(map_.columns(), map_.rows());
  std::vector<Leaf> leaves;
  const auto add_leaf = [&](double x_m, double y_m) {
    const double inside_m2 = area_m2(x_m, y_m, edge_m);
    area_m2_ += inside_m2;
    if (inside_m2 > 0.0) {
      leaves.push_back({x_m, y_m, edge_m, inside_m2});
    }
  };
  // Square by square of what a block holds: places of a block are near to each other.
  constexpr int kSide = 8;
  const double tile_m = kSide * edge_m;
  for (double y_m = std::floor(low_m.y() / tile_m) * tile_m; y_m < high_m.y(); y_m += tile_m) {
    for (double x_m = std::floor(low_m.x() / tile_m) * tile_m; x_m < high_m.x(); x_m += tile_m) {
      for (int i = 0; i < kSide * kSide; ++i) {
        add_leaf(x_m + (i % kSide + 0.5) * edge_m, y_m + (i / kSide + 0.5) * edge_m);
      }
    }
  }
  return leaves;
}

/// By the middles of the cells of the map that are in the square, or where that is smaller by the
/// cell that its middle is in.
double HypothesisGrid::area_m2(double x_m, double y_m, double edge_m) const {
  const int samples = std::max(1, static_cast<int>(std::lround(edge_m / map_.resolution_m())));
  const double step_m = edge_m / samples;
  double inside = 0.0;
  for (int j = 0; j < samples; ++j) {
    for (int i = 0; i < samples; ++i) {
      const CellIndex cell = map_.cell_at(
          {x_m - 0.5 * edge_m + (i + 0.5) * step_m, y_m - 0.5 * edge_m + (j + 0.5) * step_m});
      inside += map_.contains(cell) ? static_cast<double>(may_hold_[cell]) : 0.0;
    }
  }
  return inside * square(step_m);
}

HypothesisGrid::Response HypothesisGrid::response_at(const FieldReading& reading,
                                                     const Eigen::Vector2d& source_m,
                                                     double edge_m,
                                                     const Shielding& shielding) const {
  const double distance_m = (reading.at_m - source_m).norm();
  const double attenuation_per_m = shielding.attenuation_per_m;
  const double solid_m = attenuation_per_m > 0.0
                             ? shielding_m(solids_.between(reading.at_m, source_m), shielding)
                             : 0.0;
  return {response(distance_m, solid_m, attenuation_per_m, params_.field),
          response_variance(distance_m,
                            solid_m,
                            attenuation_per_m,
                            square(reading.position_stddev_m) + square_variance_m2(edge_m),
                            params_.field)};
}

bool HypothesisGrid::is_clear_to(const LeafBlock& block, const Eigen::Vector2d& from_m) const {
  Eigen::AlignedBox2d box;
  for (std::size_t i = 0; i < kLanes; ++i) {
    if (block.area_m2[i] > 0.0) {
      box.extend(Eigen::Vector2d(block.x_m[i], block.y_m[i]));
    }
  }
  return !box.isEmpty() && solids_.is_clear(from_m, box.center(), 0.5 * box.diagonal().norm());
}

void HypothesisGrid::add_to(LeafBlock& block, const FieldReading& reading, float times) const {
  const FieldParams& field = params_.field;
  const ReadingTerms terms = terms_of(reading, field);
  const bool is_clear = is_clear_to(block, reading.at_m);
  std::array<CrossedLengths, kLanes> crossed{};
  // Without anything on the way, all shieldings are one; without unknown, it may as well be air.
  bool is_shielded = false;
  bool is_unknown = false;
  for (std::size_t i = 0; i < kLanes && !is_clear; ++i) {
    if (block.area_m2[i] > 0.0) {
      crossed[i] = solids_.between(reading.at_m, {block.x_m[i], block.y_m[i]});
    }
    is_unknown = is_unknown || crossed[i].unknown_m > 0.0;
    is_shielded = is_shielded || is_unknown || crossed[i].solid_m > 0.0;
  }
  std::vector<float> change(nodes_.per_shielding() * kLanes);
  for (std::size_t s = 0; s < nodes_.shieldings.size(); ++s) {
    const Shielding& shielding = nodes_.shieldings[s];
    if (s == 0 || (shielding.is_unknown_solid ? is_unknown : is_shielded)) {
      set_log_likelihoods(
          terms, responses(block, reading, crossed, shielding), nodes_, change.data());
    }
    add_rows(change, times, block.lanes(s * nodes_.per_shielding()));
  }
}

ResponseLanes HypothesisGrid::responses(const LeafBlock& block,
                                        const FieldReading& reading,
                                        const std::array<CrossedLengths, kLanes>& crossed,
                                        const Shielding& shielding) const {
  ResponseLanes lanes;
  for (std::size_t i = 0; i < kLanes; ++i) {
    const double distance_m = (reading.at_m - Eigen::Vector2d(block.x_m[i], block.y_m[i])).norm();
    const double solid_m = shielding_m(crossed[i], shielding);
    const double variance_m2 =
        square(reading.position_stddev_m) + square_variance_m2(block.edge_m[i]);
    lanes.response[i] = static_cast<float>(
        response(distance_m, solid_m, shielding.attenuation_per_m, params_.field));
    lanes.variance[i] = static_cast<float>(response_variance(
        distance_m, solid_m, shielding.attenuation_per_m, variance_m2, params_.field));
  }
  return lanes;
}

void HypothesisGrid::add_to_none(const FieldReading& reading, double times) {
  const ReadingTerms terms = terms_of(reading, params_.field);
  for (std::size_t b = 0; b < none_.size(); ++b) {
    const float background = nodes_.backgrounds[b] * terms.dwell_s;
    none_[b] += times * static_cast<double>(log_likelihood(terms, 0.0F, background, 0.0F));
  }
}

void HypothesisGrid::apply(const FieldReading& reading, float times) {
  add_to_none(reading, static_cast<double>(times));
  for (LeafBlock& block : blocks_) {
    add_to(block, reading, times);
  }
}

void HypothesisGrid::add(std::span<const FieldReading> readings) {
  for (FieldReading reading : readings) {
    if (params_.field.kind == SensorKind::kLevel) {
      reading.dwell_s = 1.0;
    }
    const auto near = std::find_if(readings_.begin(), readings_.end(), [&](const auto& other) {
      return (other.at_m - reading.at_m).norm() < params_.merge_m;
    });
    if (near == readings_.end()) {
      readings_.push_back(reading);
      apply(reading, 1.0F);
      continue;
    }
    apply(*near, -1.0F);
    *near = merged(*near, reading, params_.field.kind);
    apply(*near, 1.0F);
  }
}

bool HypothesisGrid::is_splittable(LeafIndex leaf) const {
  return blocks_[leaf.block].edge_m[leaf.lane] > 1.5 * params_.min_leaf_m;
}

void HypothesisGrid::split(std::span<const LeafIndex> leaves) {
  std::vector<Leaf> quarters;
  for (const LeafIndex& index : leaves) {
    if (!is_splittable(index)) {
      continue;
    }
    LeafBlock& block = blocks_[index.block];
    const double edge_m = 0.5 * block.edge_m[index.lane];
    block.area_m2[index.lane] = 0.0;
    for (const double dy : {-0.5, 0.5}) {
      for (const double dx : {-0.5, 0.5}) {
        const double x_m = block.x_m[index.lane] + dx * edge_m;
        const double y_m = block.y_m[index.lane] + dy * edge_m;
        quarters.push_back({x_m, y_m, edge_m, area_m2(x_m, y_m, edge_m)});
      }
    }
  }
  std::erase_if(quarters, [](const Leaf& leaf) { return leaf.area_m2 <= 0.0; });
  append(quarters);
}

void HypothesisGrid::append(std::span<const Leaf> leaves) {
  for (std::size_t first = 0; first < leaves.size(); first += kLanes) {
    LeafBlock block;
    block.log_likelihood.assign(nodes_.size() * kLanes, 0.0F);
    for (std::size_t i = 0; i < std::min(kLanes, leaves.size() - first); ++i) {
      const Leaf& leaf = leaves[first + i];
      block.x_m[i] = leaf.x_m;
      block.y_m[i] = leaf.y_m;
      block.edge_m[i] = leaf.edge_m;
      block.area_m2[i] = leaf.area_m2;
    }
    for (const FieldReading& reading : readings_) {
      add_to(block, reading, 1.0F);
    }
    blocks_.push_back(std::move(block));
  }
}

void HypothesisGrid::set_background_range(double min, double max) {
  nodes_.backgrounds = geometric_range(min, max, params_.background_nodes);
  std::fill(none_.begin(), none_.end(), 0.0);
  for (LeafBlock& block : blocks_) {
    std::fill(block.log_likelihood.begin(), block.log_likelihood.end(), 0.0F);
  }
  for (const FieldReading& reading : readings_) {
    apply(reading, 1.0F);
  }
}

}  // namespace echomap::source_search

// SPDX-License-Identifier: MIT
#include "host/source_search/hypothesis_grid.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include <Eigen/Geometry>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/square.hpp"
#include "host/mapping/distance_field.hpp"

namespace echomap::source_search {

using geometry::square;
using mapping::CellState;
using mapping::RasterMap;

namespace {

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

/// The map with obstacles where it has floor, to measure distances from floor.
RasterMap floor_as_obstacle(const RasterMap& map) {
  RasterMap floor(map.columns(), map.rows(), map.resolution_m(), map.origin_m());
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      if (map.state({x, y}) == CellState::kFree) {
        floor.set({x, y}, CellState::kOccupied);
      }
    }
  }
  return floor;
}

/// Steps from the floor to each unknown cell, through unknown ones: what is behind a wall is not
/// reached. -1 for what is not.
std::vector<int> steps_into_unknown(const RasterMap& map) {
  const auto index = [&](geometry::CellIndex cell) {
    return static_cast<std::size_t>(cell.y * map.columns() + cell.x);
  };
  std::vector<int> steps(static_cast<std::size_t>(map.columns() * map.rows()), -1);
  std::deque<geometry::CellIndex> queue;
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      if (map.state({x, y}) == CellState::kFree) {
        steps[index({x, y})] = 0;
        queue.push_back({x, y});
      }
    }
  }
  constexpr int kSides[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  while (!queue.empty()) {
    const geometry::CellIndex at = queue.front();
    queue.pop_front();
    for (const auto& side : kSides) {
      const geometry::CellIndex next{at.x + side[0], at.y + side[1]};
      if (map.contains(next) && map.state(next) == CellState::kUnknown && steps[index(next)] < 0) {
        steps[index(next)] = steps[index(at)] + 1;
        queue.push_back(next);
      }
    }
  }
  return steps;
}

std::vector<bool> cells_of_source(const RasterMap& map, const HypothesisGridParams& params) {
  const double depth_m = std::max(params.solid_depth_m, map.resolution_m());
  const mapping::DistanceField from_floor(floor_as_obstacle(map), depth_m + map.resolution_m());
  const double depth_cells = params.solid_depth_m / map.resolution_m() + 1e-6;
  const double reach_cells = params.unknown_reach_m / map.resolution_m();
  const std::vector<int> steps = steps_into_unknown(map);
  std::vector<bool> may_hold;
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const int step = steps[may_hold.size()];
      const bool is_solid = map.state({x, y}) == CellState::kOccupied;
      may_hold.push_back(is_solid ? from_floor.distance_cells({x, y}) <= depth_cells
                                  : step >= 0 && step <= reach_cells);
    }
  }
  return may_hold;
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

HypothesisGrid::HypothesisGrid(const HypothesisGridParams& params, const RasterMap& map)
    : params_((validate_grid(params), params)),
      map_(map),
      may_hold_(cells_of_source(map, params)),
      solids_(map) {
  const FieldParams& field = params_.field;
  nodes_.strengths =
      geometric_range(field.min_strength, field.max_strength, params_.strength_nodes);
  nodes_.attenuations_per_m.assign(field.attenuations_per_m.begin(),
                                   field.attenuations_per_m.end());
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
  int inside = 0;
  for (int j = 0; j < samples; ++j) {
    for (int i = 0; i < samples; ++i) {
      const geometry::CellIndex cell = map_.cell_at(
          {x_m - 0.5 * edge_m + (i + 0.5) * step_m, y_m - 0.5 * edge_m + (j + 0.5) * step_m});
      inside += map_.contains(cell) &&
                        may_hold_[static_cast<std::size_t>(cell.y * map_.columns() + cell.x)]
                    ? 1
                    : 0;
    }
  }
  return inside * square(step_m);
}

HypothesisGrid::Response HypothesisGrid::response_at(const FieldReading& reading,
                                                     const Eigen::Vector2d& source_m,
                                                     double edge_m,
                                                     double attenuation_per_m) const {
  const double distance_m = (reading.at_m - source_m).norm();
  const double solid_m = attenuation_per_m > 0.0 ? solids_.between_m(reading.at_m, source_m) : 0.0;
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
  std::array<double, kLanes> distances_m{};
  std::array<double, kLanes> solids_m{};
  for (std::size_t i = 0; i < kLanes; ++i) {
    const Eigen::Vector2d leaf_m(block.x_m[i], block.y_m[i]);
    distances_m[i] = (reading.at_m - leaf_m).norm();
    solids_m[i] =
        is_clear || block.area_m2[i] <= 0.0 ? 0.0 : solids_.between_m(reading.at_m, leaf_m);
  }
  // Without any solid on the way, all attenuations are one.
  const bool is_shielded =
      std::any_of(solids_m.begin(), solids_m.end(), [](double solid_m) { return solid_m > 0.0; });
  std::vector<float> change(nodes_.per_attenuation() * kLanes);
  ResponseLanes lanes;
  for (std::size_t a = 0; a < field.attenuations_per_m.size(); ++a) {
    const double attenuation_per_m = field.attenuations_per_m[a];
    if (a == 0 || is_shielded) {
      for (std::size_t i = 0; i < kLanes; ++i) {
        const double variance_m2 =
            square(reading.position_stddev_m) + square_variance_m2(block.edge_m[i]);
        lanes.response[i] =
            static_cast<float>(response(distances_m[i], solids_m[i], attenuation_per_m, field));
        lanes.variance[i] = static_cast<float>(
            response_variance(distances_m[i], solids_m[i], attenuation_per_m, variance_m2, field));
      }
      set_log_likelihoods(terms, lanes, nodes_, change.data());
    }
    add_rows(change, times, block.lanes(a * nodes_.per_attenuation()));
  }
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

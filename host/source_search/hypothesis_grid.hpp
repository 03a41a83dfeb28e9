// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "host/exploration/cell_values.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/source_search/field_model.hpp"
#include "host/source_search/leaf_block.hpp"
#include "host/source_search/solid_lengths.hpp"
#include "host/source_search/source_floor.hpp"

namespace echomap::source_search {

/// Values without another source are ours, chosen in simulation.
struct HypothesisGridParams {
  FieldParams field;
  /// Edge of the squares at first, and of the smallest that they are split into; whole multiples of
  /// each other.
  double leaf_m = 0.2;
  double min_leaf_m = 0.05;
  /// Readings nearer to each other than this are merged.
  double merge_m = 0.05;
  std::size_t strength_nodes = 12;
  std::size_t background_nodes = 8;
  /// Unknown cells within this distance of a free one, by a path over unknown ones, may hold the
  /// source, too, as likely as that path is floor.
  double unknown_reach_m = 2.0;
  /// A source lies in a hollow: of the unknown cells between it and a sensor, the first ones up to
  /// this distance are air.
  double hollow_m = 0.5;
  /// Occupied cells no deeper than this in what is solid may hold the source, too: a source in or
  /// behind a wall can be neither found nor ruled out.
  double solid_depth_m = 0.1;
};

/// A square of the grid: the block and the lane that it is in.
struct LeafIndex {
  std::size_t block = 0;
  std::size_t lane = 0;
};

/// The log-likelihood of all readings for every place, strength, background and shielding, and for
/// no source at all, stored exactly at nodes. Places are squares that can be split where they
/// matter. The error from the size of a square is in the likelihood as an error of the rate.
class HypothesisGrid {
 public:
  /// Places are the free cells of the map, what is beside them, and unknown floor in reach.
  /// Throws std::invalid_argument for invalid parameters.
  HypothesisGrid(const HypothesisGridParams& params, const SourceFloor& floor);

  void add(std::span<const FieldReading> readings);
  /// Splits these squares into four, unless they are of the smallest.
  void split(std::span<const LeafIndex> leaves);
  /// Recomputes the likelihoods at other backgrounds, evenly spaced by logarithm.
  void set_background_range(double min, double max);

  const HypothesisGridParams& params() const { return params_; }
  const NuisanceNodes& nodes() const { return nodes_; }
  const std::vector<LeafBlock>& blocks() const { return blocks_; }
  /// Log-likelihood of no source, by background.
  const std::vector<double>& none() const { return none_; }
  /// Readings, with near ones merged.
  const std::vector<FieldReading>& readings() const { return readings_; }
  const mapping::RasterMap& map() const { return map_; }
  /// Area where the source may be, square metres; unknown floor counts by how likely it is floor.
  double area_m2() const { return area_m2_; }
  bool is_splittable(LeafIndex leaf) const;

  /// Response at a place to a source of strength 1 in the middle of a square of that edge.
  struct Response {
    double response = 0.0;
    double variance = 0.0;  ///< Relative.
  };
  Response response_at(const FieldReading& reading,
                       const Eigen::Vector2d& source_m,
                       double edge_m,
                       const Shielding& shielding) const;

 private:
  struct Leaf {
    double x_m;
    double y_m;
    double edge_m;
    double area_m2;
  };

  std::vector<Leaf> initial_leaves();
  double area_m2(double x_m, double y_m, double edge_m) const;
  void append(std::span<const Leaf> leaves);
  bool is_clear_to(const LeafBlock& block, const Eigen::Vector2d& from_m) const;
  void add_to(LeafBlock& block, const FieldReading& reading, float times) const;
  ResponseLanes responses(const LeafBlock& block,
                          const FieldReading& reading,
                          const std::array<CrossedLengths, kLanes>& crossed,
                          const Shielding& shielding) const;
  void add_to_none(const FieldReading& reading, double times);
  void apply(const FieldReading& reading, float times);

  HypothesisGridParams params_;
  mapping::RasterMap map_;
  exploration::CellValues<float> floor_chance_;  ///< By cell, of unknown ones.
  exploration::CellValues<float> may_hold_;      ///< By cell, from 0 to 1.
  SolidLengths solids_;
  NuisanceNodes nodes_;
  std::vector<LeafBlock> blocks_;
  std::vector<double> none_;
  std::vector<FieldReading> readings_;
  double area_m2_ = 0.0;
};

}  // namespace echomap::source_search

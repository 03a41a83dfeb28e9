// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <utility>

#include "host/live_page/history.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::live_page {

/// Adds to a history what has changed of a map since it was looked at last: tiles, path, walls and
/// the last sweep.
class MapPublisher {
 public:
  explicit MapPublisher(std::shared_ptr<History> history) : history_(std::move(history)) {}

  /// Cheap where nothing has changed.
  void look_at(double time_s, const pipeline::Snapshot& snapshot);
  /// A map without a path, as one that a robot is looked for in.
  void look_at(double time_s, const mapping::OccupancyGrid& grid);
  /// What comes from here on is of another map.
  void begin_new_map(double time_s);
  /// How often something has changed.
  std::uint64_t changes() const { return changes_; }

 private:
  void add_tiles(double time_s, const mapping::OccupancyGrid& grid);
  void add_trail(double time_s, const pipeline::Snapshot& snapshot);
  void add_room(double time_s, const pipeline::Snapshot& snapshot);

  std::shared_ptr<History> history_;
  std::map<std::pair<std::int32_t, std::int32_t>, std::unique_ptr<mapping::GridTile>> sent_;
  std::shared_ptr<const mapping::OccupancyGrid> grid_;
  std::uint64_t revision_ = 0;
  std::shared_ptr<const mapping::Scan> last_scan_;
  std::uint64_t changes_ = 0;
};

}  // namespace echomap::live_page

// SPDX-License-Identifier: MIT
#include "host/exploration/frontier_search.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace echomap::exploration {

namespace {

using geometry::CellIndex;
using mapping::CellState;
using mapping::RasterMap;

constexpr std::array<CellIndex, 4> kSides{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// Of each cell, what the search has made of it.
enum class Mark : std::uint8_t { kNone, kReached, kFrontier };

class Marks {
 public:
  explicit Marks(const RasterMap& map)
      : map_(map),
        marks_(static_cast<std::size_t>(map.columns()) * static_cast<std::size_t>(map.rows())) {}

  Mark& operator[](CellIndex cell) {
    return marks_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(map_.columns()) +
                  static_cast<std::size_t>(cell.x)];
  }

 private:
  const RasterMap& map_;
  std::vector<Mark> marks_;
};

CellIndex beside(CellIndex cell, CellIndex by) { return {cell.x + by.x, cell.y + by.y}; }

/// Marks all free floor that is joined to `from`; the cells beside unknown ones in the order in
/// which they were met.
std::vector<CellIndex> flood(const RasterMap& map, CellIndex from, Marks& marks) {
  std::vector<CellIndex> frontier;
  std::vector<CellIndex> waiting{from};
  marks[from] = Mark::kReached;
  while (!waiting.empty()) {
    const CellIndex cell = waiting.back();
    waiting.pop_back();
    for (const CellIndex side : kSides) {
      const CellIndex next = beside(cell, side);
      const CellState state = map.state(next);
      if (state == CellState::kUnknown && marks[cell] != Mark::kFrontier) {
        marks[cell] = Mark::kFrontier;
        frontier.push_back(cell);
      } else if (state == CellState::kFree && marks[next] == Mark::kNone) {
        marks[next] = Mark::kReached;
        waiting.push_back(next);
      }
    }
  }
  return frontier;
}

/// Takes the frontier that `seed` belongs to out of the marks.
FrontierCells take_joined(const RasterMap& map, CellIndex seed, Marks& marks) {
  FrontierCells joined;
  const auto take = [&](CellIndex cell) {
    if (map.contains(cell) && marks[cell] == Mark::kFrontier) {
      marks[cell] = Mark::kReached;
      joined.push_back(cell);
    }
  };
  take(seed);
  for (std::size_t i = 0; i < joined.size(); ++i) {
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
      for (std::int32_t dx = -1; dx <= 1; ++dx) {
        take(beside(joined[i], {dx, dy}));
      }
    }
  }
  return joined;
}

}  // namespace

std::vector<FrontierCells> find_frontiers(const RasterMap& map, CellIndex from) {
  std::vector<FrontierCells> frontiers;
  if (map.state(from) != CellState::kFree) {
    return frontiers;
  }
  Marks marks(map);
  for (const CellIndex seed : flood(map, from, marks)) {
    if (marks[seed] == Mark::kFrontier) {
      frontiers.push_back(take_joined(map, seed, marks));
    }
  }
  std::stable_sort(frontiers.begin(), frontiers.end(), [](const auto& a, const auto& b) {
    return a.size() > b.size();
  });
  return frontiers;
}

}  // namespace echomap::exploration

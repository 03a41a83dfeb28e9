// SPDX-License-Identifier: MIT
#include "host/mapping/row_minima.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "host/mapping/vector_clones.hpp"

namespace echomap::mapping {

namespace {

constexpr std::int32_t kLanes = 16;
using Lanes = std::int32_t __attribute__((vector_size(4 * kLanes)));
constexpr Lanes kLaneNumbers = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
constexpr std::int32_t kCoarse = kLanes * kLanes;

struct Candidates {
  std::int32_t first = 0;
  std::int32_t last = 0;
};

/// For 16 x, `stride` apart: heights[i] + (x - i)^2 - x^2 = (heights[i] + i^2) - 2 i x, where the
/// last term grows by 2 x from one i to the next; the least of them, and its i unless kValuesOnly.
template <bool kValuesOnly>
[[gnu::always_inline]] inline void search(const std::int32_t* lifted,
                                          Candidates among,
                                          const Lanes& doubled_x,
                                          Lanes& least,
                                          Lanes& where) {
  Lanes fall = doubled_x * among.first;
  least = Lanes{} + std::numeric_limits<std::int32_t>::max();
  for (std::int32_t i = among.first; i <= among.last; ++i) {
    const Lanes value = lifted[i] - fall;
    if constexpr (!kValuesOnly) {
      where = value < least ? Lanes{} + i : where;
    }
    least = value < least ? value : least;
    fall += doubled_x;
  }
}

/// Where the minima of 16 blocks' worth of x, `stride` apart, lie: block b among the candidates
/// from bounds[b] to bounds[b + 1].
[[gnu::always_inline]] inline void locate(const std::int32_t* lifted,
                                          const std::int32_t* bounds,
                                          std::int32_t blocks,
                                          std::int32_t first,
                                          std::int32_t stride,
                                          std::int32_t* where) {
  for (std::int32_t block = 0; block < blocks; ++block) {
    const Lanes x = first + stride * (block * kLanes + kLaneNumbers);
    Lanes least;
    Lanes found{};
    search<false>(lifted, {bounds[block], bounds[block + 1]}, x + x, least, found);
    std::memcpy(where + std::ptrdiff_t{block} * kLanes, &found, sizeof found);
  }
}

[[gnu::always_inline]] inline void evaluate(const std::int32_t* lifted,
                                            const std::int32_t* bounds,
                                            std::int32_t first,
                                            std::span<std::int32_t> minima) {
  const auto count = static_cast<std::int32_t>(minima.size());
  for (std::int32_t begin = 0; begin < count; begin += kLanes, ++bounds) {
    const Lanes x = first + begin + kLaneNumbers;
    Lanes least;
    Lanes unused{};
    search<true>(lifted, {bounds[0], bounds[1]}, x + x, least, unused);
    least += x * x;
    const std::int32_t lanes = std::min(kLanes, count - begin);
    std::memcpy(
        minima.data() + begin, &least, static_cast<std::size_t>(lanes) * sizeof(std::int32_t));
  }
}

}  // namespace

ECHOMAP_VECTOR_CLONES
void row_minima(std::span<std::int32_t> heights,
                std::int32_t first,
                std::span<std::int32_t> minima) {
  constexpr std::int32_t kMaxBlocks = kMaxRowCells / kCoarse;
  std::array<std::int32_t, kMaxBlocks + kLanes> by_256{};
  std::array<std::int32_t, kMaxRowCells / kLanes + kLanes> by_16{};
  const auto candidates = static_cast<std::int32_t>(heights.size());
  for (std::int32_t i = 0; i < candidates; ++i) {
    heights[static_cast<std::size_t>(i)] += i * i;
  }
  const auto blocks = static_cast<std::int32_t>((minima.size() + kCoarse - 1) / kCoarse);
  const std::array<std::int32_t, 2> all{0, candidates - 1};
  if (blocks == 1) {
    std::copy(all.begin(), all.end(), by_256.begin());
  } else {
    for (std::int32_t block = 0; block <= blocks; block += kLanes) {
      locate(heights.data(),
             all.data(),
             1,
             first + block * kCoarse,
             kCoarse,
             &by_256[static_cast<std::size_t>(block)]);
    }
  }
  locate(heights.data(), by_256.data(), blocks, first, kLanes, by_16.data());
  by_16[static_cast<std::size_t>(blocks) * kLanes] = by_256[static_cast<std::size_t>(blocks)];
  evaluate(heights.data(), by_16.data(), first, minima);
}

ECHOMAP_VECTOR_CLONES
void near_row_minima(std::span<const std::uint16_t> squares,
                     std::int32_t reach,
                     std::span<std::uint16_t> minima) {
  using Near = std::uint16_t __attribute__((vector_size(2 * kNearPadding)));
  for (std::size_t x = 0; x < minima.size(); x += kNearPadding) {
    const std::uint16_t* const middle = squares.data() + x + reach;
    Near least;
    std::memcpy(&least, middle, sizeof least);
    for (std::int32_t d = 1; d <= reach; ++d) {
      Near before;
      Near after;
      std::memcpy(&before, middle - d, sizeof before);
      std::memcpy(&after, middle + d, sizeof after);
      before = before < after ? before : after;
      before += static_cast<std::uint16_t>(d * d);
      least = before < least ? before : least;
    }
    const std::size_t lanes = std::min(kNearPadding, minima.size() - x);
    std::memcpy(&minima[x], &least, lanes * sizeof(std::uint16_t));
  }
}

}  // namespace echomap::mapping

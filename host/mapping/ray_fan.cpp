// SPDX-License-Identifier: MIT
#include "host/mapping/ray_fan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/mapping/vector_clones.hpp"

namespace echomap::mapping {

namespace {

constexpr double kCell = 1 << kLatticeBits;
/// A hair more than half of a cell's diagonal: as far from a ray are the centres of cells that it
/// crosses.
constexpr double kHalfDiagonal = 0.708 * kCell;
constexpr double kNoLimit = std::numeric_limits<double>::max();

std::size_t quadrant_of(double x, double y) {
  const std::size_t is_left = x < 0.0 ? 1 : 0;
  const std::size_t is_down = y < 0.0 ? 1 : 0;
  return 2 * is_down + (is_left ^ is_down);
}

ECHOMAP_VECTOR_CLONES
void find_lengths(const double* x, const double* y, std::size_t count, double* lengths) {
  for (std::size_t i = 0; i < count; ++i) {
    lengths[i] = std::sqrt(x[i] * x[i] + y[i] * y[i]);
  }
}

/// By how many more rays the next lies counter-clockwise than clockwise. Products of coordinates
/// are whole numbers below 2^41, so all of this is exact.
ECHOMAP_VECTOR_CLONES
std::int64_t count_turns(const double* x, const double* y, std::size_t count) {
  std::int64_t turns = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double sine = x[i] * y[i + 1] - y[i] * x[i + 1];
    turns += (sine > 0.0 ? 1 : 0) - (sine < 0.0 ? 1 : 0);
  }
  return turns;
}

/// `turn` is 1 where rays follow each other counter-clockwise, otherwise -1.
ECHOMAP_VECTOR_CLONES
void find_reaches(const double* x,
                  const double* y,
                  const double* lengths,
                  double turn,
                  std::size_t count,
                  double* reaches) {
  for (std::size_t i = 0; i < count; ++i) {
    const double sine = turn * (x[i] * y[i + 1] - y[i] * x[i + 1]);
    const double cosine = x[i] * x[i + 1] + y[i] * y[i + 1];
    const double shorter = lengths[i] < lengths[i + 1] ? lengths[i] : lengths[i + 1];
    const double dense = kCell * cosine / (sine > 1.0 ? sine : 1.0);
    const double reach = dense < shorter ? dense : shorter;
    reaches[i] = ((sine < 0.0) | (cosine <= 0.0)) ? -1.0 : reach;
  }
}

/// The stretch of each ray that begins at the sensor: up to where it may leave the cells that are
/// crossed. Near an axis the ray also meets cells with centres across it, up to the share h / aside
/// of its way, if h is half a diagonal: these must be crossed as far.
ECHOMAP_VECTOR_CLONES
void find_covered(const double* x,
                  const double* y,
                  const double* lengths,
                  const std::array<double, 4>& radii,
                  std::size_t count,
                  double* shares) {
  const double right_up = radii[0];
  const double left_up = radii[1];
  const double left_down = radii[2];
  const double right_down = radii[3];
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_left = x[i] < 0.0;
    const bool is_down = y[i] < 0.0;
    const double up = is_left ? left_up : right_up;
    const double down = is_left ? left_down : right_down;
    const double up_beside = is_left ? right_up : left_up;
    const double down_beside = is_left ? right_down : left_down;
    const double here = is_down ? down : up;
    const double across_x = is_down ? up : down;
    const double across_y = is_down ? down_beside : up_beside;
    const double wide = kHalfDiagonal * lengths[i];
    const bool is_clear_of_x = (across_x - kHalfDiagonal) * std::abs(y[i]) >= wide;
    const bool is_clear_of_y = (across_y - kHalfDiagonal) * std::abs(x[i]) >= wide;
    double radius = here;
    radius = ((across_x < radius) & !is_clear_of_x) ? across_x : radius;
    radius = ((across_y < radius) & !is_clear_of_y) ? across_y : radius;
    shares[i] = (radius - kHalfDiagonal) / lengths[i];
  }
}

}  // namespace

/// All pairs of neighbours together, the last and the first too, turn whole rounds, and one at
/// least where more rays lie one way than the other; so every direction lies between some pair.
void RayFan::reset(std::span<const LatticePoint> directions) {
  const std::size_t count = directions.size();
  radii_.fill(0.0);
  for (std::vector<double>* each : {&x_, &y_, &lengths_, &reaches_}) {
    each->resize(count + 1);
  }
  shares_.assign(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    x_[i] = directions[i].x;
    y_[i] = directions[i].y;
  }
  x_[count] = x_[0];
  y_[count] = y_[0];
  const std::int64_t turns = count_turns(x_.data(), y_.data(), count);
  if (turns == 0) {
    return;
  }
  find_lengths(x_.data(), y_.data(), count + 1, lengths_.data());
  find_reaches(
      x_.data(), y_.data(), lengths_.data(), turns > 0 ? 1.0 : -1.0, count, reaches_.data());
  find_radii(turns < 0);
  find_covered(x_.data(), y_.data(), lengths_.data(), radii_, count, shares_.data());
}

/// What a ray and the next reach counts in all quadrants that lie between them; kept aside while
/// these are the same.
void RayFan::find_radii(bool is_clockwise) {
  radii_.fill(kNoLimit);
  std::size_t quadrant = quadrant_of(x_[0], y_[0]);
  double least = kNoLimit;
  for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
    const std::size_t next = quadrant_of(x_[i + 1], y_[i + 1]);
    if (reaches_[i] < 0.0) {
      open_gap(i, is_clockwise);
      reaches_[i] = 0.0;
    }
    least = std::min(least, reaches_[i]);
    if (next != quadrant || i + 2 == x_.size()) {
      radii_[quadrant] = std::min(radii_[quadrant], least);
      radii_[next] = std::min(radii_[next], reaches_[i]);
      quadrant = next;
      least = kNoLimit;
    }
  }
}

/// Nothing is crossed in the quadrants between a ray and the next: counter-clockwise from one of
/// them to the other, and all around where that is more than half a round within one quadrant.
void RayFan::open_gap(std::size_t ray, bool is_clockwise) {
  const std::size_t from = is_clockwise ? ray + 1 : ray;
  const std::size_t to = is_clockwise ? ray : ray + 1;
  const std::size_t first = quadrant_of(x_[from], y_[from]);
  const std::size_t last = quadrant_of(x_[to], y_[to]);
  const bool is_around = first == last && x_[from] * y_[to] < y_[from] * x_[to];
  const std::size_t between = is_around ? 3 : (last - first) % 4;
  for (std::size_t i = 0; i <= between; ++i) {
    radii_[(first + i) % 4] = 0.0;
  }
}

}  // namespace echomap::mapping

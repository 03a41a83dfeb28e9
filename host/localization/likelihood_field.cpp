// SPDX-License-Identifier: MIT
#include "host/localization/likelihood_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/geometry/parameter_validator.hpp"
#include "host/localization/lane_math.hpp"
#include "host/localization/usable_reading.hpp"
#include "host/mapping/distance_field.hpp"
#include "host/mapping/vector_clones.hpp"

namespace echomap::localization {

namespace {

/// In cells of the field.
struct End {
  float ahead;
  float left;
};

struct FieldView {
  const float* logs;
  float origin_x_m, origin_y_m, cells_per_m, last_column, last_row;
  std::int32_t columns;
};

struct Stretch {
  static constexpr std::size_t kMost = 256;
  alignas(64) std::array<float, kMost> x;
  alignas(64) std::array<float, kMost> y;
  alignas(64) std::array<float, kMost> cos;
  alignas(64) std::array<float, kMost> sin;
  alignas(64) std::array<float, kMost> sum;
};

/// So many particles are looked up side by side.
constexpr std::size_t kAbreast = 4;

/// Where a few beams end, as numbers of cells.
struct Cells {
  static constexpr std::size_t kBeams = 8;
  alignas(64) std::array<std::array<std::int32_t, Stretch::kMost>, kBeams> of_beam;
};

[[gnu::always_inline]] inline std::int32_t cell_of(float cells, float last) {
  const float above = cells > 0.0F ? cells : 0.0F;
  return static_cast<std::int32_t>(above < last ? above : last);
}

[[gnu::always_inline]] inline void find_cells(const FieldView& view,
                                              std::span<const End> ends,
                                              std::size_t count,
                                              const Stretch& stretch,
                                              Cells& cells) {
  for (std::size_t beam = 0; beam < ends.size(); ++beam) {
    const End end = ends[beam];
    for (std::size_t i = 0; i < count; ++i) {
      const float x = stretch.x[i] + end.ahead * stretch.cos[i] - end.left * stretch.sin[i];
      const float y = stretch.y[i] + end.ahead * stretch.sin[i] + end.left * stretch.cos[i];
      cells.of_beam[beam][i] =
          cell_of(y, view.last_row) * view.columns + cell_of(x, view.last_column);
    }
  }
}

/// Loads one by one, for four particles side by side: gathering by vectors takes 1.5 times as long.
[[gnu::always_inline]] inline void add_cells(
    const float* logs, std::size_t beams, std::size_t count, const Cells& cells, Stretch& stretch) {
  for (std::size_t i = 0; i < count; i += kAbreast) {
    std::array<float, kAbreast> sums{};
    for (std::size_t beam = 0; beam < beams; ++beam) {
      for (std::size_t k = 0; k < kAbreast; ++k) {
        sums[k] += logs[cells.of_beam[beam][i + k]];
      }
    }
    for (std::size_t k = 0; k < kAbreast; ++k) {
      stretch.sum[i + k] += sums[k];
    }
  }
}

ECHOMAP_VECTOR_CLONES
// NOLINTNEXTLINE(readability-function-size): __restrict holds for parameters only
void sum_up(const FieldView view,
            const float* __restrict x_m,
            const float* __restrict y_m,
            const float* __restrict heading_rad,
            std::size_t count,
            std::span<const End> ends,
            Stretch& __restrict stretch) {
  for (std::size_t i = 0; i < count; ++i) {
    const SinCos direction = sin_cos(heading_rad[i]);
    stretch.x[i] = (x_m[i] - view.origin_x_m) * view.cells_per_m;
    stretch.y[i] = (y_m[i] - view.origin_y_m) * view.cells_per_m;
    stretch.cos[i] = direction.cos;
    stretch.sin[i] = direction.sin;
    stretch.sum[i] = 0.0F;
  }
  // What is beyond `count` holds another stretch's poses.
  const std::size_t padded = (count + kAbreast - 1) / kAbreast * kAbreast;
  Cells cells;
  for (std::size_t begin = 0; begin < ends.size(); begin += Cells::kBeams) {
    const auto some = ends.subspan(begin, std::min(Cells::kBeams, ends.size() - begin));
    find_cells(view, some, padded, stretch, cells);
    add_cells(view.logs, some.size(), padded, cells, stretch);
  }
}

const LikelihoodFieldParams& validated(const LikelihoodFieldParams& params) {
  geometry::ParameterValidator("likelihood field")
      .positive("hit_stddev_m", params.hit_stddev_m)
      .positive("random_share", params.random_share)
      .below("random_share", params.random_share, 1.0)
      .positive("max_distance_m", params.max_distance_m);
  return params;
}

}  // namespace

LikelihoodField::LikelihoodField(const mapping::RasterMap& map, const LikelihoodFieldParams& params)
    : resolution_m_(map.resolution_m()),
      origin_m_(map.origin_m() - Eigen::Vector2d::Constant(map.resolution_m())),
      columns_(map.columns() + 2),
      rows_(map.rows() + 2) {
  const mapping::DistanceField distances(
      mapping::cut_out(map, {{-1, -1}, {map.columns(), map.rows()}}),
      validated(params).max_distance_m);
  for (std::int32_t y = 0; y < rows_; ++y) {
    for (std::int32_t x = 0; x < columns_; ++x) {
      const double ratio = static_cast<double>(distances.distance_cells({x, y})) * resolution_m_ /
                           params.hit_stddev_m;
      const double hit = (1.0 - params.random_share) * std::exp(-0.5 * ratio * ratio);
      logs_.push_back(static_cast<float>(std::log(hit + params.random_share)));
    }
  }
}

double LikelihoodField::log_likelihood(const Eigen::Vector2d& end_m) const {
  const Eigen::Vector2d cells = (end_m - origin_m_) / resolution_m_;
  const auto x = static_cast<std::int32_t>(std::clamp(cells.x(), 0.0, columns_ - 0.5));
  const auto y = static_cast<std::int32_t>(std::clamp(cells.y(), 0.0, rows_ - 0.5));
  return static_cast<double>(
      logs_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(x)]);
}

void LikelihoodField::update_weights(std::span<const RangeReading> readings,
                                     float likelihood_exponent,
                                     ParticleRange range,
                                     Particles& particles) const {
  std::vector<End> ends;
  for (const RangeReading& reading : readings) {
    if (reading.range_m && is_usable(reading)) {
      const Eigen::Vector2d end =
          reading.T_robot_sensor * Eigen::Vector2d(*reading.range_m, 0.0) / resolution_m_;
      ends.push_back({static_cast<float>(end.x()), static_cast<float>(end.y())});
    }
  }
  const FieldView view{logs_.data(),
                       static_cast<float>(origin_m_.x()),
                       static_cast<float>(origin_m_.y()),
                       static_cast<float>(1.0 / resolution_m_),
                       static_cast<float>(columns_) - 0.5F,
                       static_cast<float>(rows_) - 0.5F,
                       columns_};
  Stretch stretch{};
  for (std::size_t begin = range.begin; begin < range.end; begin += Stretch::kMost) {
    const std::size_t count = std::min(Stretch::kMost, range.end - begin);
    sum_up(view,
           &particles.x_m[begin],
           &particles.y_m[begin],
           &particles.heading_rad[begin],
           count,
           ends,
           stretch);
    for (std::size_t i = 0; i < count; ++i) {
      particles.log_weight[begin + i] += likelihood_exponent * stretch.sum[i];
    }
  }
}

}  // namespace echomap::localization

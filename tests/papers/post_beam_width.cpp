// SPDX-License-Identifier: MIT
#include "tests/papers/post_beam_width.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::papers {

namespace {

using sensors::Beam;
using sensors::BeamWidth;

constexpr double kNever = -std::numeric_limits<double>::infinity();
constexpr double kGridStepRad = geometry::radians(0.5);
/// Edges up to 60 degrees off the axis.
constexpr std::size_t kEdges = 121;
constexpr std::array<double, 4> kSoftnessRad = {
    geometry::radians(0.2), geometry::radians(0.7), geometry::radians(1.5), geometry::radians(3.0)};
constexpr std::array<double, 6> kOnAxisChances = {0.5, 0.6, 0.8, 0.9, 0.95, 0.99};
constexpr std::array<double, 4> kBesideChances = {0.01, 0.05, 0.2, 0.4};
/// Half of chi-squared's 95 % quantile with one degree of freedom.
constexpr double kLikelihoodFall = 1.92;

/// Whether the target was heard so far off the middle of a sweep.
struct Trial {
  double off_rad;
  bool heard;
};

/// What equation (1) has beside the edge; both edges share it.
struct Shape {
  double on_axis;
  double beside;
  double softness_rad;
};

std::vector<Trial> trials_of(std::span<const Beam> sweep, const PostBeamWidthParams& params) {
  if (params.target_range_m <= 0.0 || params.tolerance_m <= 0.0 || params.width_m < 0.0) {
    throw std::invalid_argument("post beam width: ranges are above 0, a width is not negative");
  }
  std::vector<Trial> trials;
  for (const Beam& reading : sweep) {
    const bool heard =
        reading.range_m && std::abs(*reading.range_m - params.target_range_m) <= params.tolerance_m;
    trials.push_back({reading.bearing_rad, heard});
  }
  return trials;
}

/// Of each edge.
std::array<double, kEdges> log_likelihood(const std::vector<Trial>& side, const Shape& shape) {
  std::array<double, kEdges> sums{};
  for (std::size_t i = 0; i < kEdges; ++i) {
    const double edge_rad = static_cast<double>(i) * kGridStepRad;
    for (const Trial& trial : side) {
      const double within = 1.0 / (1.0 + std::exp((trial.off_rad - edge_rad) / shape.softness_rad));
      const double chance = shape.beside + (shape.on_axis - shape.beside) * within;  // (1)
      sums[i] += std::log(trial.heard ? chance : 1.0 - chance);
    }
  }
  return sums;
}

/// Calls `add` with every shape.
template <typename Adder>
void for_shapes(Adder&& add) {
  for (const double on_axis : kOnAxisChances) {
    for (const double beside : kBesideChances) {
      for (const double softness_rad : kSoftnessRad) {
        add(Shape{on_axis, beside, softness_rad});
      }
    }
  }
}

/// The likeliest opening and its bounds; `step_rad` between two values of the profile. Empty where
/// it does not fall to both sides.
std::optional<BeamWidth> peak_of(const std::vector<double>& profile, double step_rad) {
  const auto best = std::max_element(profile.begin(), profile.end());
  const auto is_likely = [&](double value) { return value >= *best - kLikelihoodFall; };
  if (is_likely(profile.front()) || is_likely(profile.back())) {
    return std::nullopt;
  }
  // Outwards to the grid's next steps.
  const auto low = std::find_if(profile.begin(), profile.end(), is_likely) - 1;
  const auto high = std::find_if(profile.rbegin(), profile.rend(), is_likely).base();
  const auto angle_rad = [&](auto value) {
    return step_rad * static_cast<double>(value - profile.begin());
  };
  return BeamWidth{angle_rad(best), angle_rad(low), angle_rad(high)};
}

/// The middle one of the bearings at which the target was heard; empty for fewer than three.
std::optional<double> middle_rad(const std::vector<Trial>& trials) {
  std::vector<double> from_first_rad;
  double first_rad = 0.0;
  for (const Trial& trial : trials) {
    if (trial.heard) {
      first_rad = from_first_rad.empty() ? trial.off_rad : first_rad;
      from_first_rad.push_back(geometry::angle_between(first_rad, trial.off_rad));
    }
  }
  if (from_first_rad.size() < 3) {
    return std::nullopt;
  }
  const auto middle =
      from_first_rad.begin() + static_cast<std::ptrdiff_t>(from_first_rad.size() / 2);
  std::nth_element(from_first_rad.begin(), middle, from_first_rad.end());
  return first_rad + *middle;
}

}  // namespace

std::optional<BeamWidth> beam_width_past_post(std::span<const Beam> sweep,
                                              const PostBeamWidthParams& params) {
  const std::vector<Trial> trials = trials_of(sweep, params);
  const auto axis_rad = middle_rad(trials);
  if (!axis_rad) {
    return std::nullopt;
  }
  std::array<std::vector<Trial>, 2> sides;
  for (const Trial& trial : trials) {
    const double off_rad = geometry::angle_between(*axis_rad, trial.off_rad);
    sides[off_rad < 0.0 ? 0 : 1].push_back({std::abs(off_rad), trial.heard});
  }
  std::vector<double> profile(2 * kEdges - 1, kNever);
  for_shapes([&](const Shape& shape) {
    const auto right = log_likelihood(sides[0], shape);
    const auto left = log_likelihood(sides[1], shape);
    for (std::size_t i = 0; i < kEdges; ++i) {
      for (std::size_t j = 0; j < kEdges; ++j) {
        profile[i + j] = std::max(profile[i + j], right[i] + left[j]);
      }
    }
  });
  auto opening = peak_of(profile, kGridStepRad);
  if (opening) {
    const double width_rad = 2.0 * std::atan(0.5 * params.width_m / params.target_range_m);
    opening->beam_width_rad -= width_rad;
    opening->low_rad -= width_rad;
    opening->high_rad -= width_rad;
  }
  return opening;
}

std::optional<BeamWidth> beam_width_by_tilt(std::span<const Beam> tilts,
                                            const PostBeamWidthParams& params) {
  std::vector<Trial> trials = trials_of(tilts, params);
  if (!middle_rad(trials)) {
    return std::nullopt;
  }
  for (Trial& trial : trials) {
    trial.off_rad = std::abs(trial.off_rad);
  }
  std::vector<double> profile(kEdges, kNever);
  for_shapes([&](const Shape& shape) {
    const auto side = log_likelihood(trials, shape);
    for (std::size_t i = 0; i < kEdges; ++i) {
      profile[i] = std::max(profile[i], side[i]);
    }
  });
  return peak_of(profile, 2.0 * kGridStepRad);
}

}  // namespace echomap::papers

// SPDX-License-Identifier: MIT
#include "host/diagnosis/fault_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "host/geometry/angle.hpp"

namespace echomap::diagnosis {
namespace {

/// A kind of fault: the robot with one of that value, the value that a robot of some errors has,
/// those at which the search for the best one starts, and how far it goes from there.
struct Hypothesis {
  FaultKind kind;
  RobotErrors (*errors_of)(double value);
  double (*value_of)(const RobotErrors& errors);
  std::vector<double> values;
  double step = 0.0;   ///< First step of the search; 0 where the value is given.
  double reach = 0.0;  ///< From the value at which it starts.
};

RobotErrors wheels(double left_scale, double right_scale) {
  RobotErrors errors;
  errors.left_scale = left_scale;
  errors.right_scale = right_scale;
  return errors;
}

/// Of one wheel against the other: what both have in common does not bend the way.
double left_of(const RobotErrors& errors) { return errors.left_scale / errors.right_scale; }
double right_of(const RobotErrors& errors) { return errors.right_scale / errors.left_scale; }
double mean_of(const RobotErrors& errors) { return 0.5 * (errors.left_scale + errors.right_scale); }
double no_value(const RobotErrors& /*errors*/) { return 0.0; }

Hypothesis size_of(FaultKind kind,
                   RobotErrors (*errors_of)(double),
                   double (*value_of)(const RobotErrors&)) {
  return {kind, errors_of, value_of, {0.88, 0.92, 1.08, 1.12}, 0.02, 0.06};
}

Hypothesis counts_of(FaultKind kind,
                     RobotErrors (*errors_of)(double),
                     double (*value_of)(const RobotErrors&)) {
  return {kind, errors_of, value_of, {0.5, 2.0}};
}

Hypothesis wiring(FaultKind kind, RobotErrors (*errors_of)(double)) {
  return {kind, errors_of, no_value, {0.0}};
}

std::vector<Hypothesis> wheel_hypotheses() {
  return {size_of(
              FaultKind::kLeftWheelSize, [](double size) { return wheels(size, 1.0); }, left_of),
          size_of(
              FaultKind::kRightWheelSize, [](double size) { return wheels(1.0, size); }, right_of),
          size_of(
              FaultKind::kWheelSize, [](double size) { return wheels(size, size); }, mean_of),
          counts_of(
              FaultKind::kLeftCounts,
              [](double counts) { return wheels(1.0 / counts, 1.0); },
              [](const RobotErrors& errors) { return 1.0 / left_of(errors); }),
          counts_of(
              FaultKind::kRightCounts,
              [](double counts) { return wheels(1.0, 1.0 / counts); },
              [](const RobotErrors& errors) { return 1.0 / right_of(errors); }),
          counts_of(
              FaultKind::kCounts,
              [](double counts) { return wheels(1.0 / counts, 1.0 / counts); },
              [](const RobotErrors& errors) { return 1.0 / mean_of(errors); }),
          wiring(FaultKind::kLeftReversed, [](double) { return wheels(-1.0, 1.0); }),
          wiring(FaultKind::kRightReversed, [](double) { return wheels(1.0, -1.0); }),
          wiring(FaultKind::kBothReversed, [](double) { return wheels(-1.0, -1.0); }),
          wiring(FaultKind::kNotMoving, [](double) { return wheels(0.0, 0.0); })};
}

std::vector<Hypothesis> sonar_hypotheses() {
  const auto off = [](double degrees) { return geometry::radians(degrees); };
  return {wiring(FaultKind::kPanReversed,
                 [](double) {
                   RobotErrors errors;
                   errors.pan_scale = -1.0;
                   return errors;
                 }),
          {FaultKind::kPanOffset,
           [](double offset_rad) {
             RobotErrors errors;
             errors.pan_offset_rad = offset_rad;
             return errors;
           },
           [](const RobotErrors& errors) { return errors.pan_offset_rad; },
           {off(-12.0), off(-7.0), off(7.0), off(12.0)},
           0.03,
           0.06},
          {FaultKind::kRangeScale,
           [](double scale) {
             RobotErrors errors;
             errors.range_scale = scale;
             return errors;
           },
           [](const RobotErrors& errors) { return errors.range_scale; },
           {0.9, 1.1},
           0.02,
           0.06}};
}

std::vector<Hypothesis> hypotheses() {
  std::vector<Hypothesis> all{wiring(FaultKind::kNone, [](double) { return RobotErrors(); })};
  for (const auto& some : {wheel_hypotheses(), sonar_hypotheses()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

constexpr double kNever = std::numeric_limits<double>::infinity();

/// What every robot is off by, in standard deviations of a sound one, and the value of its fault in
/// steps.
using Estimate = std::array<double, 6>;
constexpr std::size_t kSoundErrors = 5;

RobotErrors errors_at(const Estimate& at,
                      const Hypothesis& hypothesis,
                      double value,
                      const SoundRobot& sound) {
  RobotErrors errors = hypothesis.errors_of(value + hypothesis.step * at[kSoundErrors]);
  const double size = 1.0 + sound.wheel_size * at[0];
  const double mismatch = 0.5 * sound.wheel_mismatch * at[1];
  errors.left_scale *= size - mismatch;
  errors.right_scale *= size + mismatch;
  errors.track_scale *= 1.0 + sound.track * at[2];
  errors.pan_offset_rad += sound.pan_rad * at[3];
  errors.range_scale *= 1.0 + sound.range * at[4];
  return errors;
}

double log_prior(const Estimate& at) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kSoundErrors; ++i) {
    sum -= 0.5 * at[i] * at[i];
  }
  return sum;
}

/// An estimate and how good it is.
struct Scored {
  Estimate at;
  double score = 0.0;
};

/// One step along each axis, to the better side; answers whether there was one.
template <class Score>
bool improve(Scored& best, std::size_t axes, double step, const Score& score) {
  const double before = best.score;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    for (const double side : {step, -step}) {
      Scored there = best;
      there.at[axis] += side;
      there.score = score(there.at);
      best = there.score > best.score ? there : best;
    }
  }
  return best.score > before;
}

/// The pattern search of Hooke and Jeeves (1961) without its pattern moves: along each axis by
/// steps that are halved.
template <class Score>
Scored best_near(const Estimate& at, std::size_t axes, double last_step, const Score& score) {
  constexpr double kFirstStep = 1.0;
  Scored best{at, score(at)};
  for (double step = kFirstStep; step > last_step;) {
    step = improve(best, axes, step, score) ? step : 0.5 * step;
  }
  return best;
}

/// Of all values with wide tolerances first, roughly, by which a search finds what it would pass by
/// otherwise; from the best of them on with those that hold.
Explanation best_of(const Hypothesis& hypothesis,
                    const StandLog& log,
                    const FaultSearchParams& params) {
  constexpr double kWider = 2.5;
  constexpr double kRoughStep = 0.3;
  constexpr double kFineStep = 0.1;
  StandAgreementParams wide = params.agreement;
  wide.bearing_stddev_rad *= kWider;
  wide.depth_stddev_m *= kWider;
  wide.point_stddev_m *= kWider;
  const std::size_t axes = hypothesis.step > 0.0 ? kSoundErrors + 1 : kSoundErrors;
  const auto search = [&](double value,
                          const Estimate& start,
                          double last_step,
                          const StandAgreementParams& agreement) {
    return best_near(start, axes, last_step, [&](const Estimate& at) {
      const bool is_beyond = std::abs(hypothesis.step * at[kSoundErrors]) > hypothesis.reach;
      return is_beyond ? -kNever
                       : log_prior(at) +
                             log_agreement(
                                 log, errors_at(at, hypothesis, value, params.sound), agreement);
    });
  };

  Estimate start{};
  double value = 0.0;
  double best_rough = -kNever;
  for (const double one : hypothesis.values) {
    const auto [at, rough] = search(one, {}, kRoughStep, wide);
    if (rough > best_rough) {
      best_rough = rough;
      start = at;
      value = one;
    }
  }
  const auto [at, log_posterior] = search(value, start, kFineStep, params.agreement);
  return {{hypothesis.kind, hypothesis.value_of(errors_at(at, hypothesis, value, params.sound))},
          log_posterior};
}

}  // namespace

std::vector<Explanation> explain(const StandLog& log, const FaultSearchParams& params) {
  std::vector<Explanation> explanations;
  for (const Hypothesis& hypothesis : hypotheses()) {
    explanations.push_back(best_of(hypothesis, log, params));
  }
  std::stable_sort(explanations.begin(), explanations.end(), [](const auto& a, const auto& b) {
    return a.log_posterior > b.log_posterior;
  });
  return explanations;
}

}  // namespace echomap::diagnosis

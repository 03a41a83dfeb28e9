// SPDX-License-Identifier: MIT
#include "host/exports/sonar_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/LU>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::exports {
namespace {

/// A robot that has moved farther begins another sweep.
constexpr double kSamePlaceM = 0.01;
/// Less is a second reading of the same direction, more is not the next one.
constexpr double kMinStepRad = geometry::radians(0.1);
constexpr double kMaxStepRad = geometry::radians(60.0);
/// What a reading may lie off its place in even steps: of a step, and in all.
constexpr double kStepTolerance = 0.25;
constexpr double kMaxBearingErrorRad = geometry::radians(0.5);
/// So many readings may be missing in a row.
constexpr long kMaxMissing = 8;
/// Lines of sight that cross at less than some 6 degrees do not tell where.
constexpr double kMinCrossing = 0.01;

/// A reading and which step of its sweep it is, from 0.
struct SweepStep {
  long number;
  const mapping::PlacedReading* reading;
};

/// A sweep that readings are added to as long as they continue it.
class SweepInProgress {
 public:
  explicit SweepInProgress(const mapping::PlacedReading& first) : steps_{{0, &first}} {}

  /// Answers whether the reading continues the sweep; if not, it is not added.
  bool add(const mapping::PlacedReading& reading) {
    const SweepStep last = steps_.back();
    const double turn_rad = geometry::angle_between(last.reading->T_map_sonar.heading_rad(),
                                                    reading.T_map_sonar.heading_rad());
    const Eigen::Vector2d moved_m =
        reading.T_map_robot.position_m() - steps_.front().reading->T_map_robot.position_m();
    if (moved_m.norm() > kSamePlaceM ||
        std::abs(turned_rad_ + turn_rad) >= geometry::kFullTurnRad - kMaxBearingErrorRad) {
      return false;
    }
    const long steps = steps_in(turn_rad);
    if (steps == 0) {
      return false;
    }
    steps_.push_back({last.number + steps, &reading});
    turned_rad_ += turn_rad;
    return true;
  }

  SonarSweep sweep() const {
    const long last = steps_.back().number;
    const mapping::PlacedReading& first = *steps_.front().reading;
    SonarSweep sweep;
    sweep.T_map_robot = first.T_map_robot;
    sweep.T_map_sensor = {
        axis_m().x(), axis_m().y(), first.T_map_sonar.heading_rad() + 0.5 * turned_rad_};
    sweep.first_rad = -0.5 * std::abs(turned_rad_);
    sweep.step_rad = last > 0 ? std::abs(turned_rad_) / static_cast<double>(last) : 0.0;
    sweep.readings.resize(static_cast<std::size_t>(last) + 1);
    for (const SweepStep& step : steps_) {
      const long place = turned_rad_ < 0.0 ? last - step.number : step.number;
      sweep.readings[static_cast<std::size_t>(place)] =
          as_from(sweep.T_map_sensor.position_m(), *step.reading);
    }
    return sweep;
  }

 private:
  /// How many steps a turn from the last reading is; 0 where it is none.
  long steps_in(double turn_rad) const {
    const long last = steps_.back().number;
    if (last == 0) {
      return std::abs(turn_rad) >= kMinStepRad && std::abs(turn_rad) <= kMaxStepRad ? 1 : 0;
    }
    const double step_rad = turned_rad_ / static_cast<double>(last);
    const long steps = std::lround(turn_rad / step_rad);
    const double error_rad = std::abs(turn_rad - static_cast<double>(steps) * step_rad);
    const bool is_even =
        error_rad <= std::min(kStepTolerance * std::abs(step_rad), kMaxBearingErrorRad);
    return is_even && steps >= 1 && steps <= kMaxMissing + 1 ? steps : 0;
  }

  /// The point nearest to all lines of sight, by least squares; the mean of the sonar's places
  /// where these are all but parallel.
  Eigen::Vector2d axis_m() const {
    Eigen::Matrix2d across = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right_side = Eigen::Vector2d::Zero();
    Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
    for (const SweepStep& step : steps_) {
      const geometry::Pose2& T_map_sonar = step.reading->T_map_sonar;
      const Eigen::Vector2d ahead = geometry::unit_vector(T_map_sonar.heading_rad());
      const Eigen::Matrix2d projector = Eigen::Matrix2d::Identity() - ahead * ahead.transpose();
      across += projector;
      right_side += projector * T_map_sonar.position_m();
      sum_m += T_map_sonar.position_m();
    }
    const auto count = static_cast<double>(steps_.size());
    if (across.determinant() < kMinCrossing * count * count) {
      return sum_m / count;
    }
    return across.inverse() * right_side;
  }

  static SweepReading as_from(const Eigen::Vector2d& axis_m,
                              const mapping::PlacedReading& reading) {
    SweepReading moved{reading.range_m, reading.has_answered};
    if (moved.range_m) {
      const Eigen::Vector2d ahead = geometry::unit_vector(reading.T_map_sonar.heading_rad());
      *moved.range_m += (reading.T_map_sonar.position_m() - axis_m).dot(ahead);
    }
    return moved;
  }

  std::vector<SweepStep> steps_;
  double turned_rad_ = 0.0;  ///< From the first reading to the last.
};

}  // namespace

std::vector<SonarSweep> sweeps_of(const mapping::Scan& scan) {
  std::vector<SonarSweep> sweeps;
  std::optional<SweepInProgress> sweep;
  for (const mapping::PlacedReading& reading : scan) {
    if (sweep && sweep->add(reading)) {
      continue;
    }
    if (sweep) {
      sweeps.push_back(sweep->sweep());
    }
    sweep.emplace(reading);
  }
  if (sweep) {
    sweeps.push_back(sweep->sweep());
  }
  return sweeps;
}

}  // namespace echomap::exports

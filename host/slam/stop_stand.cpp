// SPDX-License-Identifier: MIT
#include "host/slam/stop_stand.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::slam {

namespace {

using geometry::Pose2;

/// Readings from `first` on that were taken where that one was.
std::size_t resting_from(const std::vector<StopReading>& readings,
                         std::size_t first,
                         const StopStandParams& params) {
  std::size_t count = 1;
  while (first + count < readings.size() && is_near(readings[first].mark.T_odom_robot,
                                                    readings[first + count].mark.T_odom_robot,
                                                    params.same_m,
                                                    params.same_rad)) {
    ++count;
  }
  return count;
}

}  // namespace

void validate(const StopStandParams& params) {
  geometry::ParameterValidator("stands of a stop")
      .positive("same_rad", params.same_rad)
      .positive("same_m", params.same_m)
      .at_least("min_readings", params.min_readings, 1);
}

std::vector<StopStand> stands_in(const std::vector<StopReading>& readings,
                                 std::size_t stop,
                                 const StopStandParams& params) {
  std::vector<StopStand> stands;
  for (std::size_t first = 0; first < readings.size();) {
    const std::size_t resting = resting_from(readings, first, params);
    if (stands.empty() || resting >= params.min_readings) {
      stands.push_back({stop, first, resting, first + resting});
    }
    first += resting;
    stands.back().last = first;
  }
  return stands;
}

bool is_near(const Pose2& one, const Pose2& other, double near_m, double near_rad) {
  const Pose2 T_one_other = one.inverse() * other;
  return T_one_other.position_m().norm() <= near_m &&
         std::abs(T_one_other.heading_rad()) <= near_rad;
}

bool are_near(const std::vector<Pose2>& some,
              const std::vector<Pose2>& others,
              double near_m,
              double near_rad) {
  return std::equal(
      some.begin(), some.end(), others.begin(), others.end(), [&](const Pose2& a, const Pose2& b) {
        return is_near(a, b, near_m, near_rad);
      });
}

}  // namespace echomap::slam

// SPDX-License-Identifier: MIT
#include "host/tracking/pose_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/geometry/angle.hpp"

namespace echomap::tracking {

using localization::LocalizationStatus;

namespace {

/// A place of that probability may be that of the robot.
constexpr double kMayFit = 0.05;

/// The most probable places of several: "A 1.20, 0.40 m, 90 degrees (0.55); B ..".
std::string some_of(const localization::PoseBelief& belief) {
  constexpr std::size_t kMost = 3;
  std::string text;
  const std::size_t count = std::min(kMost, places_that_fit(belief));
  for (std::size_t i = 0; i < count; ++i) {
    const localization::PoseHypothesis& place = belief.hypotheses[i];
    text += fmt::format("{}{} {} ({:.2f})",
                        i == 0 ? "" : "; ",
                        static_cast<char>('A' + static_cast<int>(i)),
                        text_of(place.T_map_robot),
                        place.probability);
  }
  return text;
}

}  // namespace

std::string name_of(LocalizationStatus status) {
  switch (status) {
    case LocalizationStatus::kLost:
      return "lost";
    case LocalizationStatus::kRecovering:
      return "recovering";
    case LocalizationStatus::kLocalized:
      return "localized";
  }
  return "";
}

std::size_t places_that_fit(const localization::PoseBelief& belief) {
  return static_cast<std::size_t>(
      std::count_if(belief.hypotheses.begin(), belief.hypotheses.end(), [](const auto& place) {
        return place.probability >= kMayFit;
      }));
}

std::string text_of(const geometry::Pose2& T_map_robot) {
  return fmt::format("{:.2f}, {:.2f} m, {:.0f} degrees",
                     T_map_robot.x_m(),
                     T_map_robot.y_m(),
                     geometry::degrees(T_map_robot.heading_rad()));
}

std::string text_of(const localization::PoseBelief& belief) {
  if (belief.hypotheses.empty()) {
    return name_of(belief.status) + ", it may be anywhere";
  }
  const std::size_t places = places_that_fit(belief);
  if (belief.status != LocalizationStatus::kLocalized && places > 1) {
    return fmt::format("{}, {} places fit: {}", name_of(belief.status), places, some_of(belief));
  }
  return fmt::format("{}, {} (not there with probability {:.2f})",
                     name_of(belief.status),
                     text_of(belief.hypotheses.front().T_map_robot),
                     belief.lost_probability);
}

nlohmann::ordered_json to_json(const geometry::Pose2& T_map_robot,
                               const Eigen::Matrix3d& covariance) {
  return {{"x_m", T_map_robot.x_m()},
          {"y_m", T_map_robot.y_m()},
          {"heading_rad", T_map_robot.heading_rad()},
          {"std_x_m", std::sqrt(covariance(0, 0))},
          {"std_y_m", std::sqrt(covariance(1, 1))},
          {"std_heading_rad", std::sqrt(covariance(2, 2))}};
}

nlohmann::ordered_json to_json(const localization::PoseBelief& belief) {
  nlohmann::ordered_json json{{"status", name_of(belief.status)},
                              {"lost_probability", belief.lost_probability},
                              {"hypotheses", nlohmann::ordered_json::array()}};
  for (const localization::PoseHypothesis& hypothesis : belief.hypotheses) {
    json["hypotheses"].push_back(to_json(hypothesis.T_map_robot, hypothesis.covariance));
    json["hypotheses"].back()["probability"] = hypothesis.probability;
  }
  return json;
}

}  // namespace echomap::tracking

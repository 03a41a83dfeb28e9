// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "host/localization/monte_carlo_localizer.hpp"

namespace echomap::tracking {

/// "lost", "recovering" or "localized".
std::string name_of(localization::LocalizationStatus status);

/// For people: "1.20, 0.40 m, 90 degrees".
std::string text_of(const geometry::Pose2& T_map_robot);

/// How many places have a probability of 0.05 and more.
std::size_t places_that_fit(const localization::PoseBelief& belief);

/// For people: the status, the first hypothesis and how likely the robot is not there; of several
/// places that fit, the most probable.
std::string text_of(const localization::PoseBelief& belief);

/// Place and standard deviations: x_m, y_m, heading_rad, std_x_m, std_y_m, std_heading_rad.
nlohmann::ordered_json to_json(const geometry::Pose2& T_map_robot,
                               const Eigen::Matrix3d& covariance);

/// status, lost_probability and hypotheses.
nlohmann::ordered_json to_json(const localization::PoseBelief& belief);

}  // namespace echomap::tracking

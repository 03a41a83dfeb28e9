// SPDX-License-Identifier: MIT
#include "host/fleet/exchange_params.hpp"

#include "host/geometry/parameter_validator.hpp"
#include "host/mqtt/fleet_name.hpp"

namespace echomap::fleet {

void validate(const FleetExchangeParams& params) {
  geometry::ParameterValidator("fleet exchange")
      .require(mqtt::is_fleet_name(params.fleet),
               "fleet has 1 to 32 characters of a-z, 0-9, _ and -")
      .require(mqtt::is_fleet_name(params.robot),
               "robot has 1 to 32 characters of a-z, 0-9, _ and -")
      .positive("boot_id", params.boot_id)
      .require(fleet_messages::with_traits({}, params.traits).has_value(),
               "traits are lengths below 65 m and angles below 2 pi")
      .positive_finite("bytes_per_s", params.bytes_per_s)
      .positive_finite("burst_bytes", params.burst_bytes)
      .positive_finite("presence_period_s", params.presence_period_s)
      .above("gone_after_s", params.gone_after_s, params.presence_period_s)
      .nonnegative_finite("pose_period_s", params.pose_period_s)
      .nonnegative_finite("pose_moved_m", params.pose_moved_m)
      .nonnegative_finite("pose_moved_rad", params.pose_moved_rad)
      .positive_finite("pose_repeat_s", params.pose_repeat_s)
      .nonnegative_finite("compare_after_s", params.compare_after_s)
      .positive_finite("confirm_within_s", params.confirm_within_s)
      .nonnegative_finite("request_after_s", params.request_after_s)
      .positive_finite("request_period_s", params.request_period_s)
      .nonnegative_finite("answer_period_s", params.answer_period_s)
      .nonnegative_finite("relay_step_s", params.relay_step_s);
}

}  // namespace echomap::fleet

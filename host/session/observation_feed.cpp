// SPDX-License-Identifier: MIT
#include "host/session/observation_feed.hpp"

namespace echomap::session {

void ObservationFeed::take(const protocol::Odometry& message) {
  sink_.on_odometry(converter_.convert(message));
  const auto hazards = converter_.with_bumps_of(message, hazards_);
  if (hazards.bump_left != hazards_.bump_left || hazards.bump_right != hazards_.bump_right) {
    hazards_ = hazards;
    sink_.on_hazards(hazards_);
  }
}

void ObservationFeed::take(const protocol::Echo& message) {
  sink_.on_sonar(converter_.convert(message));
}

void ObservationFeed::take(const protocol::Health& message) {
  if (const auto battery = converter_.convert(message)) {
    sink_.on_battery(*battery);
  }
}

void ObservationFeed::take(const protocol::Ranges& message) {
  sink_.on_infrared(converter_.convert(message));
}

void ObservationFeed::take(const protocol::Gyro& message) {
  if (const auto yaw = converter_.convert(message)) {
    sink_.on_yaw(*yaw);
  }
}

void ObservationFeed::take(const protocol::EncoderErrors& message) {
  sink_.on_encoder_errors(converter_.convert(message));
}

void ObservationFeed::take(const protocol::Scalar& message) {
  if (const auto scalar = converter_.convert(message)) {
    sink_.on_scalar(*scalar);
  }
}

void ObservationFeed::take(const protocol::Status& message) {
  hazards_ = converter_.convert(message);
  sink_.on_hazards(hazards_);
}

}  // namespace echomap::session

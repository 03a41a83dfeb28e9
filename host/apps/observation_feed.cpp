// SPDX-License-Identifier: MIT
#include "host/apps/observation_feed.hpp"

namespace echomap::apps {

void ObservationFeed::take(const protocol::Odometry& message) {
  sink_.on_odometry(converter_.convert(message));
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

sensors::HazardObservation ObservationFeed::take(const protocol::Status& message) {
  const auto hazards = converter_.convert(message);
  sink_.on_hazards(hazards);
  return hazards;
}

}  // namespace echomap::apps

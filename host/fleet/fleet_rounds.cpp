// SPDX-License-Identifier: MIT
#include "host/fleet/fleet_rounds.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

#include "host/geometry/parameter_validator.hpp"
#include "host/mqtt/fleet_name.hpp"

namespace echomap::fleet {

using fleet_messages::ClockMessage;
using fleet_messages::FleetMessage;
using fleet_messages::PresenceMessage;
using fleet_messages::PresenceState;
using fleet_messages::TopicKind;
using fleet_messages::TopicMessage;

FleetRounds::FleetRounds(mqtt::MessageBus& bus, const FleetRoundsParams& params)
    : bus_(bus), params_(params), living_(params.members.begin(), params.members.end()) {
  geometry::ParameterValidator("fleet rounds")
      .require(mqtt::is_fleet_name(params.fleet), "fleet is a name")
      .require(std::all_of(living_.begin(), living_.end(), mqtt::is_fleet_name),
               "members have names")
      .require(living_.contains(params.robot), "robot is a member")
      .positive_finite("repeat_after_s", params.repeat_after_s);
}

bool FleetRounds::publish(const std::string& topic,
                          std::string_view payload,
                          mqtt::Delivery /*delivery*/,
                          bool retain) {
  if (!bus_.publish(topic, payload, mqtt::Delivery::kAtLeastOnce, retain)) {
    return false;
  }
  note_sent(topic, payload, retain);
  return true;
}

std::vector<mqtt::Message> FleetRounds::take() {
  if (!has_ended_) {
    serve();
  }
  return std::exchange(ready_, {});
}

void FleetRounds::end_round(bool leaves) {
  ClockMessage clock{round_, last_counter_, static_cast<std::uint8_t>(leaves ? 1 : 0), objects_};
  FleetMessage message;
  message.sender = {params_.robot, params_.boot_id, round_ + 1};
  message.body = clock;
  const std::string topic =
      fleet_messages::format_topic({params_.fleet, params_.robot, TopicKind::kClock, {}});
  // Small enough: a round has few objects.
  const std::string payload = fleet_messages::encode(message).value_or("");
  bus_.publish(topic, payload, mqtt::Delivery::kAtLeastOnce, true);
  sent_.push_back({topic, payload, true});
  objects_.clear();
  has_ended_ = true;
  repeated_s_.reset();
}

bool FleetRounds::poll(double wall_s) {
  serve();
  if (!repeated_s_) {
    repeated_s_ = wall_s;
  }
  if (bus_.connections() != connections_ || wall_s >= *repeated_s_ + params_.repeat_after_s) {
    connections_ = bus_.connections();
    repeated_s_ = wall_s;
    resend();
  }
  if (!has_ended_) {
    return true;
  }
  if (!is_over()) {
    return false;
  }
  release();
  has_ended_ = false;
  sent_before_ = std::exchange(sent_, {});
  ++round_;
  return true;
}

std::vector<std::string> FleetRounds::waits_for() const {
  std::vector<std::string> missing;
  std::copy_if(living_.begin(), living_.end(), std::back_inserter(missing), [&](const auto& robot) {
    return !has_all_of(robot);
  });
  return missing;
}

void FleetRounds::serve() {
  for (mqtt::Message& message : bus_.take()) {
    sort_in(std::move(message));
  }
}

void FleetRounds::sort_in(mqtt::Message message) {
  const auto decoded = fleet_messages::decode(message.topic, message.payload);
  const auto* known = std::get_if<TopicMessage>(&decoded);
  if (known == nullptr || !living_.contains(known->topic.robot)) {
    ready_.push_back(std::move(message));  // The receiver validates it.
    return;
  }
  const std::string& robot = known->topic.robot;
  const FleetMessage& fleet_message = known->message;
  Received& received = received_[robot];
  if (known->topic.kind == TopicKind::kClock) {
    take_clock(robot, fleet_message);
    return;
  }
  const auto* presence = std::get_if<PresenceMessage>(&fleet_message.body);
  const bool is_will =
      presence != nullptr && presence->state == static_cast<std::uint8_t>(PresenceState::kGone);
  if (is_will && robot != params_.robot && !message.is_retained) {
    living_.erase(robot);
  }
  if (is_will || known->topic.kind == TopicKind::kRelay) {
    ready_.push_back(std::move(message));
  } else if (fleet_messages::is_object(known->topic.kind)) {
    if (message.is_retained) {
      ready_.push_back(message);  // It may be of a round that is over.
    }
    received.objects.insert_or_assign(fleet_messages::content_hash(message.payload),
                                      std::move(message));
  } else if (fleet_message.sender.boot_id != params_.boot_id ||
             fleet_message.sender.counter <= received.released_counter) {
    ready_.push_back(std::move(message));  // From before this run, or a repetition.
  } else {
    received.messages.insert_or_assign(fleet_message.sender.counter, std::move(message));
  }
}

void FleetRounds::take_clock(const std::string& robot, const FleetMessage& message) {
  const auto& clock = std::get<ClockMessage>(message.body);
  if (message.sender.boot_id == params_.boot_id && clock.round >= round_) {
    received_[robot].clocks[clock.round] = clock;
  }
}

bool FleetRounds::has_all_of(const std::string& robot) const {
  const auto found = received_.find(robot);
  if (found == received_.end()) {
    return false;
  }
  const Received& received = found->second;
  const auto clock = received.clocks.find(round_);
  if (clock == received.clocks.end()) {
    return false;
  }
  const auto end = received.messages.upper_bound(clock->second.last_counter);
  const auto messages = static_cast<std::uint32_t>(std::distance(received.messages.begin(), end));
  return messages == clock->second.last_counter - received.released_counter &&
         std::all_of(clock->second.objects.begin(),
                     clock->second.objects.end(),
                     [&](const auto& object) { return received.objects.contains(object); });
}

bool FleetRounds::is_over() const {
  return std::all_of(
      living_.begin(), living_.end(), [&](const auto& robot) { return has_all_of(robot); });
}

void FleetRounds::release() {
  std::vector<std::string> leaving;
  for (const std::string& robot : living_) {
    Received& received = received_[robot];
    release(received);
    const auto clock = received.clocks.find(round_);
    if (clock->second.leaves == 1) {
      leaving.push_back(robot);
    }
    received.clocks.erase(clock);
  }
  for (const std::string& robot : leaving) {
    living_.erase(robot);
  }
}

void FleetRounds::release(Received& received) {
  const ClockMessage& clock = received.clocks.at(round_);
  for (const auto& object : clock.objects) {
    // It stays: a robot may publish it once more in a later round.
    ready_.push_back(received.objects.at(object));
  }
  const auto end = received.messages.upper_bound(clock.last_counter);
  for (auto message = received.messages.begin(); message != end; ++message) {
    ready_.push_back(std::move(message->second));
  }
  received.messages.erase(received.messages.begin(), end);
  received.released_counter = clock.last_counter;
}

void FleetRounds::resend() {
  for (const std::vector<Sent>* round : {&sent_before_, &sent_}) {
    for (const Sent& message : *round) {
      bus_.publish(
          message.topic, message.payload, mqtt::Delivery::kAtLeastOnce, message.is_retained);
    }
  }
}

void FleetRounds::note_sent(const std::string& topic, std::string_view payload, bool retain) {
  sent_.push_back({topic, std::string(payload), retain});
  const auto decoded = fleet_messages::decode(topic, payload);
  const auto* known = std::get_if<TopicMessage>(&decoded);
  if (known == nullptr || known->topic.kind == TopicKind::kRelay) {
    return;
  }
  if (fleet_messages::is_object(known->topic.kind)) {
    objects_.push_back(fleet_messages::content_hash(payload));
  } else {
    last_counter_ = std::max(last_counter_, known->message.sender.counter);
  }
}

}  // namespace echomap::fleet

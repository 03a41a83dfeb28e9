// SPDX-License-Identifier: MIT
#include "host/fleet/fleet_knowledge.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace echomap::fleet {

using fleet_messages::ContentHash;
using fleet_messages::FleetMessage;
using fleet_messages::RefusedReason;
using fleet_messages::TopicKind;
using fleet_messages::TopicMessage;

namespace {

bool is_last_will(const FleetMessage& message) {
  const auto* presence = std::get_if<fleet_messages::PresenceMessage>(&message.body);
  return presence != nullptr &&
         presence->state == static_cast<std::uint8_t>(fleet_messages::PresenceState::kGone);
}

}  // namespace

FleetKnowledge::FleetKnowledge(std::string fleet, std::string robot, double gone_after_s)
    : fleet_(std::move(fleet)), robot_(std::move(robot)), gone_after_s_(gone_after_s) {}

void FleetKnowledge::take(const mqtt::Message& message, double now_s) {
  ++statistics_.messages;
  statistics_.bytes += message.topic.size() + message.payload.size();
  if (message.payload.empty()) {
    return;  // The retained message of the topic was deleted.
  }
  const auto decoded = fleet_messages::decode(message.topic, message.payload);
  if (const auto* reason = std::get_if<RefusedReason>(&decoded)) {
    refuse(*reason);
    return;
  }
  const auto& known = std::get<TopicMessage>(decoded);
  if (known.topic.fleet != fleet_) {
    refuse(RefusedReason::kWrongTopic);
  } else if (known.message.sender.robot != robot_) {
    take_foreign(known, message, now_s);
  } else if (known.topic.kind != TopicKind::kRelay) {
    take_found(known, message);
  }
}

void FleetKnowledge::take_own(const fleet_messages::MessageBody& body,
                              const ContentHash& hash,
                              double now_s) {
  RobotKnowledge& own = knowledge_of(robot_);
  own.set_last_seen(now_s);
  if (fleet_messages::is_object(fleet_messages::kind_of(body)) && objects_.insert(hash).second) {
    object_set_.reset();
  }
  revision_ += own.take(body, hash, now_s) ? 1 : 0;
}

std::vector<ReceivedRequest> FleetKnowledge::take_requests() {
  return std::exchange(requests_, {});
}

std::vector<FoundPayload> FleetKnowledge::take_found_own() { return std::exchange(found_own_, {}); }

FleetState FleetKnowledge::state(double now_s) const {
  FleetState state;
  for (const auto& [name, robot] : robots_) {
    state.robots.push_back(robot.state(now_s, gone_after_s_));
  }
  state.objects = objects_.size();
  state.object_set = object_set();
  state.revision = revision_;
  return state;
}

bool FleetKnowledge::is_alive(const std::string& robot, double now_s) const {
  const auto found = robots_.find(robot);
  return found != robots_.end() &&
         found->second.attendance(now_s, gone_after_s_) == Attendance::kAlive;
}

ContentHash FleetKnowledge::object_set() const {
  if (!object_set_) {
    object_set_ = fleet_messages::set_hash({objects_.begin(), objects_.end()});
  }
  return *object_set_;
}

std::size_t FleetKnowledge::missing_objects() const {
  std::size_t missing = 0;
  for (const auto& [name, robot] : robots_) {
    const std::vector<ContentHash> promised = robot.promised();
    const std::optional<fleet_messages::PresenceMessage>& presence = robot.presence();
    const std::size_t made = presence ? presence->own_objects : 0;
    const auto here = static_cast<std::size_t>(
        std::ranges::count_if(promised, [&](const ContentHash& object) { return has(object); }));
    missing += std::max(made, promised.size()) - here;
  }
  return missing;
}

const std::map<std::string, StoredPayload>& FleetKnowledge::stored(const std::string& robot) const {
  static const std::map<std::string, StoredPayload> none;
  const auto found = stored_.find(robot);
  return found == stored_.end() ? none : found->second;
}

RobotKnowledge& FleetKnowledge::knowledge_of(const std::string& robot) {
  return robots_.try_emplace(robot, robot).first->second;
}

void FleetKnowledge::take_foreign(const TopicMessage& decoded,
                                  const mqtt::Message& message,
                                  double now_s) {
  const FleetMessage& fleet_message = decoded.message;
  const bool is_relayed = decoded.topic.kind == TopicKind::kRelay;
  const ContentHash hash = fleet_messages::content_hash(message.payload);
  if (is_relayed && !accepts_relay(fleet_message, hash, now_s)) {
    ++statistics_.ignored_relays;
    return;
  }
  if (!has_room_for(fleet_message)) {
    refuse(RefusedReason::kOverQuota);
    return;
  }
  const std::string topic = is_relayed ? fleet_messages::format_topic(fleet_messages::topic_of(
                                             fleet_, fleet_message, message.payload))
                                       : message.topic;
  auto& stored = stored_[fleet_message.sender.robot];
  if (const auto known = stored.find(topic);
      known != stored.end() && known->second.payload == message.payload) {
    known->second.last_received_s = now_s;
  }
  if (!is_new(decoded, topic, message.is_retained || is_relayed)) {
    return;
  }
  const TopicKind kind = fleet_messages::kind_of(fleet_message.body);
  if (is_passed_on(kind) || is_in_latest_set(kind)) {
    stored[topic] = {kind, fleet_message.sender.boot_id, message.payload, now_s};
  }
  RobotKnowledge& author = knowledge_of(fleet_message.sender.robot);
  if (!is_relayed) {
    author.note_boot(fleet_message.sender.boot_id);
  }
  if (message.is_retained && !is_relayed) {
    author.set_first_seen(now_s);
  } else if (!is_relayed) {
    author.set_last_seen(now_s);
  }
  const auto* presence = std::get_if<fleet_messages::PresenceMessage>(&fleet_message.body);
  if (presence != nullptr && !is_last_will(fleet_message) && !message.is_retained && !is_relayed) {
    compare_latest(fleet_message.sender, *presence);
  }
  take_new(fleet_message, hash, now_s);
}

void FleetKnowledge::take_new(const FleetMessage& message, const ContentHash& hash, double now_s) {
  RobotKnowledge& author = knowledge_of(message.sender.robot);
  if (is_last_will(message)) {
    author.lose();
    if (author.presence()) {
      return;  // It is newer than the will and holds more.
    }
  }
  if (const auto* request = std::get_if<fleet_messages::AskMessage>(&message.body)) {
    if (!robot_.empty()) {
      requests_.push_back({message.sender.robot, *request});
    }
    return;
  }
  if (fleet_messages::is_object(fleet_messages::kind_of(message.body))) {
    if (!objects_.insert(hash).second) {
      ++statistics_.duplicates;
      return;
    }
    object_set_.reset();
  }
  revision_ += author.take(message.body, hash, now_s) ? 1 : 0;
}

void FleetKnowledge::compare_latest(const fleet_messages::Sender& sender,
                                    const fleet_messages::PresenceMessage& presence) {
  std::vector<ContentHash> latest;
  for (const auto& [topic, stored] : stored_[sender.robot]) {
    if (is_in_latest_set(stored.kind) && stored.boot_id == sender.boot_id) {
      latest.push_back(fleet_messages::content_hash(stored.payload));
    }
  }
  if (fleet_messages::set_hash(std::move(latest)) == presence.latest_set) {
    behind_.erase(sender.robot);
  } else {
    behind_.insert(sender.robot);
  }
}

void FleetKnowledge::take_found(const TopicMessage& decoded, const mqtt::Message& message) {
  const FleetMessage& fleet_message = decoded.message;
  const TopicKind kind = fleet_messages::kind_of(fleet_message.body);
  const bool is_found = fleet_messages::is_object(kind)
                            ? !has(fleet_messages::content_hash(message.payload))
                            : kind == TopicKind::kGraph;
  if (message.is_retained) {
    retained_boot_id_ = std::max(retained_boot_id_, fleet_message.sender.boot_id);
  }
  if (is_found && message.is_retained) {
    found_own_.push_back({decoded, message.payload});
  }
}

bool FleetKnowledge::is_new(const TopicMessage& decoded,
                            const std::string& topic,
                            bool is_of_the_past) {
  const FleetMessage& fleet_message = decoded.message;
  if (fleet_messages::is_object(fleet_messages::kind_of(fleet_message.body))) {
    return true;  // Its name is its hash: nobody can send an older one.
  }
  if (is_last_will(fleet_message)) {
    // It was made before all other messages of its boot, and the broker sends it after them.
    const bool is_of_this_boot =
        fleet_message.sender.boot_id >= guard_.boot_id(fleet_message.sender.robot);
    if (!is_of_this_boot && !is_of_the_past) {
      refuse(RefusedReason::kOldBoot);
    }
    return is_of_this_boot;
  }
  const bool is_relayed = decoded.topic.kind == TopicKind::kRelay;
  if (is_relayed && !guard_.is_news(topic, fleet_message.sender)) {
    ++statistics_.outdated;
    return false;
  }
  switch ((is_relayed ? relays_guard_ : guard_).take(topic, fleet_message.sender, is_of_the_past)) {
    case Freshness::kNew:
      return true;
    case Freshness::kDuplicate:
      ++statistics_.duplicates;
      break;
    case Freshness::kOutdated:
      ++statistics_.outdated;
      break;
    case Freshness::kReplayed:
      refuse(RefusedReason::kReplayed);
      break;
    case Freshness::kOldBoot:
      refuse(RefusedReason::kOldBoot);
      break;
  }
  return false;
}

bool FleetKnowledge::accepts_relay(const FleetMessage& message,
                                   const ContentHash& hash,
                                   double now_s) const {
  const auto author = robots_.find(message.sender.robot);
  return is_passed_on(fleet_messages::kind_of(message.body)) &&
         (!is_alive(message.sender.robot, now_s) || author->second.has_promised(hash));
}

bool FleetKnowledge::has_room_for(const FleetMessage& message) const {
  const auto author = robots_.find(message.sender.robot);
  return author == robots_.end() ? robots_.size() < kMaxRobots
                                 : author->second.has_room_for(message.body);
}

void FleetKnowledge::refuse(RefusedReason reason) {
  ++statistics_.refused[static_cast<std::size_t>(reason)];
}

}  // namespace echomap::fleet

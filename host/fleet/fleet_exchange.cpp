// SPDX-License-Identifier: MIT
#include "host/fleet/fleet_exchange.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "host/fleet_messages/payload.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::fleet {

using fleet_messages::ContentHash;
using fleet_messages::FleetMessage;
using fleet_messages::FleetTopic;
using fleet_messages::MessageBody;
using fleet_messages::PresenceMessage;
using fleet_messages::PresenceState;
using fleet_messages::TopicKind;

namespace {

/// Period of comparing what the fleet has with what it should have.
constexpr double kLookPeriodS = 1.0;

FleetMessage message_of(const FleetExchangeParams& params,
                        std::uint32_t counter,
                        const MessageBody& body) {
  FleetMessage message;
  message.sender.robot = params.robot;
  message.sender.boot_id = params.boot_id;
  message.sender.counter = counter;
  message.body = body;
  return message;
}

PresenceMessage presence_like(const FleetExchangeParams& params, PresenceState state) {
  PresenceMessage message = fleet_messages::with_traits({}, params.traits).value();
  message.state = static_cast<std::uint8_t>(state);
  return message;
}

const FleetExchangeParams& checked(const FleetExchangeParams& params) {
  validate(params);
  return params;
}

}  // namespace

mqtt::LastWill last_will(const FleetExchangeParams& params) {
  validate(params);
  const FleetMessage message = message_of(params, 0, presence_like(params, PresenceState::kGone));
  return {fleet_messages::format_topic({params.fleet, params.robot, TopicKind::kPresence, {}}),
          fleet_messages::encode(message).value(),
          true};
}

FleetExchange::FleetExchange(mqtt::MessageBus& bus, const FleetExchangeParams& params)
    : bus_(bus),
      params_(checked(params)),
      folder_(params.folder),
      knowledge_(params.fleet, params.robot, params.gone_after_s),
      publications_(params),
      relays_(params),
      missing_(params) {
  load();
  bus_.subscribe(fleet_messages::fleet_filter(params_.fleet));
  // Claims of an earlier start of this host are void.
  set_claims({});
}

void FleetExchange::begin_map() {
  ++map_number_;
  has_own_submap_ = false;
  pose_.reset();
  sent_pose_.reset();
  set_claims({});
}

std::optional<team_map::Submap> FleetExchange::add_submap(const team_map::Submap& submap) {
  const auto message = fleet_messages::to_message(submap, map_number_);
  if (!message || !add_object(*message)) {
    return std::nullopt;
  }
  has_own_submap_ = true;
  return fleet_messages::to_submap(*message);
}

std::optional<fleet_messages::SourceBatch> FleetExchange::add_source_batch(
    const fleet_messages::SourceBatch& batch) {
  const auto message = fleet_messages::to_message(batch, map_number_);
  if (!message || !add_object(*message)) {
    return std::nullopt;
  }
  return fleet_messages::to_source_batch(*message);
}

bool FleetExchange::set_graph(const std::vector<geometry::Pose2>& T_map_submaps,
                              const Eigen::Matrix3d& latest_covariance) {
  const auto message =
      fleet_messages::to_graph_message(T_map_submaps, latest_covariance, map_number_);
  return message && publish(*message, Worth::kGraph);
}

bool FleetExchange::set_claims(const std::vector<team_exploration::Claim>& claims) {
  const auto message = fleet_messages::to_message(claims, map_number_);
  return message && publish(*message, Worth::kUrgent);
}

bool FleetExchange::set_search(const fleet_messages::SearchReport& report) {
  const auto message = fleet_messages::to_message(report, map_number_);
  return message && publish(*message, Worth::kUrgent);
}

bool FleetExchange::set_alignment(const std::vector<fleet_messages::AlignedMap>& maps) {
  const auto message = fleet_messages::to_message(maps);
  return message && publish(*message, Worth::kGraph);
}

bool FleetExchange::set_pose(const fleet_messages::PoseEstimate& pose, double stamp_s) {
  const auto message = fleet_messages::to_message(pose, stamp_s, map_number_);
  if (message) {
    pose_ = *message;
    knowledge_.take_own(*message, {}, now_s_);
  }
  return message.has_value();
}

void FleetExchange::leave() {
  has_left_ = true;
  set_claims({});
  send_presence(PresenceState::kLeft);
}

void FleetExchange::update(double now_s) {
  now_s_ = now_s;
  take_in();
  if (!bus_.is_connected()) {
    return;
  }
  if (!looked_s_ || now_s >= *looked_s_ + kLookPeriodS) {
    looked_s_ = now_s;
    look_around();
  }
  send_pose();
  if (!has_left_ && (!presence_sent_s_ || now_s >= *presence_sent_s_ + params_.presence_period_s)) {
    send_presence(PresenceState::kHere);
  }
  publications_.send(
      bus_, [this](const MessageBody& body) { return encode(body); }, now_s);
}

ExchangeStatistics FleetExchange::statistics() const {
  return {publications_.statistics(),
          knowledge_.statistics(),
          publications_.waiting(),
          requests_,
          relays_.count(),
          unsaved_};
}

void FleetExchange::load() {
  for (const std::string& payload : folder_.load()) {
    const auto decoded = fleet_messages::decode(payload);
    const auto* message = std::get_if<FleetMessage>(&decoded);
    // The others are damaged or of another robot.
    if (message != nullptr && message->sender.robot == params_.robot) {
      adopt(fleet_messages::topic_of(params_.fleet, *message, payload), *message, payload);
    }
  }
}

void FleetExchange::take_in() {
  const std::vector<mqtt::Message> messages = bus_.take();
  if (bus_.connections() != connections_) {
    connections_ = bus_.connections();
    publications_.on_connected(now_s_);
    relays_.on_connected(now_s_);
  }
  for (const mqtt::Message& message : messages) {
    publications_.confirm(message.topic, message.payload);
    knowledge_.take(message, now_s_);
  }
  for (const FoundPayload& found : knowledge_.take_found_own()) {
    if (adopt(found.decoded.topic, found.decoded.message, found.payload)) {
      save(found.decoded.message.body, found.payload);
    }
  }
  for (const ReceivedRequest& received : knowledge_.take_requests()) {
    answer(received);
  }
  constexpr std::uint32_t kLastBoot = std::numeric_limits<std::uint32_t>::max();
  if (knowledge_.retained_boot_id() > params_.boot_id) {
    begin_later_boot(knowledge_.retained_boot_id() +
                     (knowledge_.retained_boot_id() < kLastBoot ? 1 : 0));
  }
}

/// A clock that was set back, or not set yet, has given this start a boot id that was used before:
/// its messages are ignored and have to be sent again.
void FleetExchange::begin_later_boot(std::uint32_t boot_id) {
  params_.boot_id = boot_id;
  presence_sent_s_.reset();
  sent_pose_.reset();
  publications_.resend();
}

bool FleetExchange::adopt(const FleetTopic& topic,
                          const FleetMessage& message,
                          const std::string& payload) {
  const ContentHash hash = fleet_messages::content_hash(payload);
  const bool is_object = fleet_messages::is_object(topic.kind);
  if (publications_.has(fleet_messages::format_topic(topic))) {
    return false;
  }
  knowledge_.take_own(message.body, hash, now_s_);
  if (is_object) {
    publications_.restore(topic, payload, payload, Worth::kObject);
    list_object(hash);
  } else {
    publications_.restore(topic, message.body, payload, Worth::kGraph);
  }
  const auto number = fleet_messages::map_number_of(message.body);
  if (number && *number >= map_number_ && !has_own_submap_) {
    map_number_ = static_cast<std::uint16_t>(*number + 1);
  }
  return true;
}

void FleetExchange::answer(const ReceivedRequest& received) {
  if (received.request.robot != params_.robot) {
    relays_.note(received, knowledge_, now_s_);
    return;
  }
  for (const ContentHash& object : received.request.objects) {
    for (const TopicKind kind : {TopicKind::kSubmap, TopicKind::kSource}) {
      publications_.repeat(
          fleet_messages::format_topic({params_.fleet, params_.robot, kind, object}), now_s_);
    }
  }
  if (received.request.everything_else == 1) {
    publications_.repeat_all(
        [](TopicKind kind) { return is_in_latest_set(kind) || kind == TopicKind::kManifest; },
        now_s_);
  }
}

void FleetExchange::look_around() {
  publications_.compare(now_s_);
  relays_.update(knowledge_, publications_, now_s_);
  if (const auto request = missing_.next(knowledge_, now_s_)) {
    publish(*request, Worth::kUrgent);
    ++requests_;
  }
}

void FleetExchange::send_presence(PresenceState state) {
  presence_sent_s_ = now_s_;
  publish(presence_like(params_, state), Worth::kUrgent);
}

void FleetExchange::send_pose() {
  if (!pose_) {
    return;
  }
  const geometry::Pose2 T_map_robot = fleet_messages::to_pose_estimate(*pose_).T_map_robot;
  if (sent_pose_) {
    const double age_s = now_s_ - sent_pose_->at_s;
    const bool has_moved =
        (T_map_robot.position_m() - sent_pose_->T_map_robot.position_m()).norm() >=
            params_.pose_moved_m ||
        std::abs(geometry::angle_between(sent_pose_->T_map_robot.heading_rad(),
                                         T_map_robot.heading_rad())) >= params_.pose_moved_rad;
    if (age_s < (has_moved ? params_.pose_period_s : params_.pose_repeat_s)) {
      return;
    }
  }
  sent_pose_ = SentPose{T_map_robot, now_s_};
  publish(*pose_, Worth::kUrgent);
}

bool FleetExchange::publish(const MessageBody& body, Worth worth) {
  const FleetMessage message = message_of(params_, 0, body);
  const auto payload = fleet_messages::encode(message);
  if (!payload) {
    return false;
  }
  knowledge_.take_own(body, {}, now_s_);
  publications_.put(fleet_messages::topic_of(params_.fleet, message, *payload), body, worth);
  return true;
}

bool FleetExchange::add_object(const MessageBody& body) {
  const FleetMessage message = message_of(params_, 0, body);
  const auto payload = fleet_messages::encode(message);
  if (!payload) {
    return false;
  }
  const ContentHash hash = fleet_messages::content_hash(*payload);
  if (knowledge_.has(hash)) {
    return true;
  }
  save(body, *payload);
  knowledge_.take_own(body, hash, now_s_);
  publications_.put(
      fleet_messages::topic_of(params_.fleet, message, *payload), *payload, Worth::kObject);
  list_object(hash);
  return true;
}

void FleetExchange::list_object(const ContentHash& hash) {
  constexpr std::size_t kPerPage = fleet_messages::ManifestMessage::kObjectsPerPage;
  own_objects_.push_back(hash);
  const std::size_t page = (own_objects_.size() - 1) / kPerPage;
  const auto first = own_objects_.begin() + static_cast<std::ptrdiff_t>(page * kPerPage);
  publish(fleet_messages::ManifestMessage{static_cast<std::uint16_t>(page),
                                          {first, own_objects_.end()}},
          Worth::kObject);
}

void FleetExchange::save(const MessageBody& body, const std::string& payload) {
  const auto* graph = std::get_if<fleet_messages::GraphMessage>(&body);
  const bool is_saved = graph == nullptr ? folder_.save_object(payload)
                                         : folder_.save_graph(graph->map_number, payload);
  unsaved_ += is_saved ? 0 : 1;
}

std::optional<std::string> FleetExchange::encode(const MessageBody& body) {
  FleetMessage message = message_of(params_, ++counter_, body);
  if (auto* presence = std::get_if<PresenceMessage>(&message.body)) {
    presence->map_number = map_number_;
    presence->own_objects = listed_objects_;
    presence->latest_set = fleet_messages::set_hash(publications_.sent_hashes(is_in_latest_set));
    presence->known_objects = static_cast<std::uint32_t>(knowledge_.object_count());
    presence->known_set = knowledge_.object_set();
    knowledge_.take_own(*presence, {}, now_s_);
  }
  if (const auto* page = std::get_if<fleet_messages::ManifestMessage>(&body)) {
    const std::size_t before = page->page * fleet_messages::ManifestMessage::kObjectsPerPage;
    listed_objects_ =
        std::max(listed_objects_, static_cast<std::uint32_t>(before + page->objects.size()));
  }
  auto payload = fleet_messages::encode(message);
  if (payload && std::holds_alternative<fleet_messages::GraphMessage>(body)) {
    save(body, *payload);
  }
  return payload;
}

}  // namespace echomap::fleet

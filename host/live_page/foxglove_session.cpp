// SPDX-License-Identifier: MIT
#include "host/live_page/foxglove_session.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

namespace echomap::live_page {

/// What is wrong with one frame of the client: the first thing, and how many there are.
struct FoxgloveSession::Complaints {
  void add(std::string text) {
    if (count++ == 0) {
      first = std::move(text);
    }
  }

  std::string first;
  std::size_t count = 0;
};

namespace {

using nlohmann::json;

constexpr std::uint8_t kMessageDataOpcode = 1;
constexpr std::uint8_t kTimeOpcode = 2;
constexpr int kErrorLevel = 2;
/// The keys of messages are their channels, from 1 on.
constexpr std::uint64_t kTimeKey = 0;
constexpr std::uint64_t kStatusKey = std::uint64_t{1} << 32;
constexpr std::uint64_t kTimePeriodNs = 10'000'000;
/// A clock that goes back makes clients forget; only a new run's does.
constexpr std::uint64_t kNewRunNs = 1'000'000'000;
constexpr std::size_t kMaxQuotedBytes = 40;
/// What is nested deeper is left out: values are copied and destroyed by recursion.
constexpr int kMaxDepth = 4;
constexpr std::size_t kMessageHeadBytes = 13;

constexpr std::string_view kPictures[] = {"nav_msgs/msg/OccupancyGrid",
                                          "nav_msgs/msg/Path",
                                          "visualization_msgs/msg/MarkerArray",
                                          "geometry_msgs/msg/PoseArray"};

template <class T>
void append_little_endian(std::string& bytes, T value) {
  for (std::size_t i = 0; i < sizeof value; ++i) {
    bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFF));
  }
}

FoxgloveFrame json_frame(const json& message) {
  return {true, message.dump(-1, ' ', false, json::error_handler_t::replace)};
}

/// A client that sends nothing but nonsense leaves one status waiting.
FoxgloveFrame status_frame(std::string text, std::size_t others) {
  if (others > 0) {
    text += " (and " + std::to_string(others) + " more)";
  }
  FoxgloveFrame frame =
      json_frame({{"op", "status"}, {"level", kErrorLevel}, {"message", std::move(text)}});
  frame.delivery = FoxgloveDelivery::kNewest;
  frame.key = kStatusKey;
  return frame;
}

json advertisement(const FoxgloveChannel& channel) {
  return {{"id", channel.id},
          {"topic", channel.topic},
          {"encoding", "cdr"},
          {"schemaName", channel.schema_name},
          {"schemaEncoding", "ros2msg"},
          {"schema", channel.schema_text}};
}

/// Null unless the value is an integer that fits.
std::optional<std::uint32_t> id_in(const json& value) {
  if (!value.is_number_unsigned() ||
      value.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max()) {
    return std::nullopt;
  }
  return value.get<std::uint32_t>();
}

/// Null where the object has no such entry.
json entry_of(const json& object, const char* name) {
  return object.is_object() ? object.value(name, json()) : json();
}

std::string quoted(const json& value) {
  return value.dump(-1, ' ', true, json::error_handler_t::replace).substr(0, kMaxQuotedBytes);
}

}  // namespace

FoxgloveSession::Frames FoxgloveSession::begin() {
  const FoxgloveTopics::News last = topics_.since(std::numeric_limits<std::uint64_t>::max());
  last_number_ = last.last_number;
  now_ns_ = last.log_time_ns;
  generation_ = last.generation;
  // Supported encodings are those of a client's messages, and none is taken.
  Frames frames{json_frame({{"op", "serverInfo"},
                            {"name", "echomap"},
                            {"capabilities", json::array({"time"})},
                            {"sessionId", topics_.session_id()}})};
  json channels = json::array();
  for (const SharedFoxgloveChannel& channel : topics_.channels()) {
    channels.push_back(advertisement(*channel));
    channels_[channel->id] = channel;
  }
  frames.push_back(json_frame({{"op", "advertise"}, {"channels", std::move(channels)}}));
  return frames;
}

void FoxgloveSession::update_channels(Frames& frames) {
  std::map<std::uint32_t, SharedFoxgloveChannel> now;
  json added = json::array();
  for (const SharedFoxgloveChannel& channel : topics_.channels()) {
    now[channel->id] = channel;
    if (!channels_.contains(channel->id)) {
      added.push_back(advertisement(*channel));
    }
  }
  json gone = json::array();
  for (const auto& [id, channel] : channels_) {
    if (!now.contains(id)) {
      gone.push_back(id);
      subscriptions_.erase(id);
    }
  }
  channels_ = std::move(now);
  if (!gone.empty()) {
    frames.push_back(json_frame({{"op", "unadvertise"}, {"channelIds", std::move(gone)}}));
  }
  if (!added.empty()) {
    frames.push_back(json_frame({{"op", "advertise"}, {"channels", std::move(added)}}));
  }
}

FoxgloveSession::Frames FoxgloveSession::receive_text(std::string_view text) {
  if (text.size() > kMaxTextBytes) {
    return {status_frame("a message is longer than 64 KiB", 0)};
  }
  const json message = json::parse(
      text, [](int depth, auto, const auto&) { return depth <= kMaxDepth; }, false);
  const json op = entry_of(message, "op");
  Frames frames;
  Complaints complaints;
  if (op == "subscribe") {
    subscribe(entry_of(message, "subscriptions"), complaints, frames);
  } else if (op == "unsubscribe") {
    unsubscribe(entry_of(message, "subscriptionIds"), complaints);
  } else if (op.is_string()) {
    complaints.add("echomap does not take the op " + quoted(op));
  } else {
    complaints.add("a message is no JSON object with an op");
  }
  if (complaints.count > 0) {
    frames.push_back(status_frame(std::move(complaints.first), complaints.count - 1));
  }
  return frames;
}

FoxgloveSession::Frames FoxgloveSession::receive_binary(std::string_view /*bytes*/) {
  return {status_frame("echomap takes no binary messages", 0)};
}

void FoxgloveSession::subscribe(const json& wishes, Complaints& complaints, Frames& frames) {
  if (!wishes.is_array()) {
    complaints.add("subscribe has no array of subscriptions");
    return;
  }
  for (const json& wish : wishes) {
    subscribe_one(wish, complaints, frames);
  }
}

void FoxgloveSession::subscribe_one(const json& wish, Complaints& complaints, Frames& frames) {
  const json wished_channel = entry_of(wish, "channelId");
  const auto id = id_in(entry_of(wish, "id"));
  const auto channel = id_in(wished_channel);
  if (!id || !channel) {
    complaints.add("a subscription is no pair of id and channelId");
    return;
  }
  const auto known = channels_.find(*channel);
  if (known == channels_.end()) {
    complaints.add("there is no channel " + quoted(wished_channel));
    return;
  }
  const bool is_used = std::ranges::any_of(
      subscriptions_, [&](const auto& entry) { return entry.second.id == *id; });
  if (is_used || subscriptions_.contains(*channel)) {
    complaints.add("channel " + quoted(wished_channel) +
                   " or the subscription's id has a subscription");
    return;
  }
  const bool is_picture =
      std::ranges::find(kPictures, known->second->schema_name) != std::ranges::end(kPictures);
  subscriptions_[*channel] = {*id, is_picture, 0};
  if (const SharedFoxgloveMessage newest = topics_.newest(*channel)) {
    add_time(frames);
    add_message(*newest, frames);
  }
}

void FoxgloveSession::unsubscribe(const json& ids, Complaints& complaints) {
  if (!ids.is_array()) {
    complaints.add("unsubscribe has no array of subscriptionIds");
    return;
  }
  for (const json& one : ids) {
    const auto id = id_in(one);
    const auto erased =
        std::erase_if(subscriptions_, [&](const auto& entry) { return entry.second.id == id; });
    if (erased == 0) {
      complaints.add("there is no subscription " + quoted(one));
    }
  }
}

FoxgloveSession::Frames FoxgloveSession::news() {
  Frames frames;
  const FoxgloveTopics::News news = topics_.since(last_number_);
  if (news.generation != generation_) {
    generation_ = news.generation;
    update_channels(frames);
  }
  for (const SharedFoxgloveMessage& message : news.messages) {
    now_ns_ = message->log_time_ns;
    if (!subscriptions_.empty()) {
      add_time(frames);
    }
    add_message(*message, frames);
  }
  last_number_ = news.last_number;
  now_ns_ = news.log_time_ns;
  return frames;
}

void FoxgloveSession::add_time(Frames& frames) {
  if (told_ns_ && now_ns_ + kNewRunNs > *told_ns_ && now_ns_ < *told_ns_ + kTimePeriodNs) {
    return;
  }
  told_ns_ = now_ns_;
  FoxgloveFrame frame{false, {}, FoxgloveDelivery::kNewest, kTimeKey};
  append_little_endian(frame.bytes, kTimeOpcode);
  append_little_endian(frame.bytes, now_ns_);
  frames.push_back(std::move(frame));
}

void FoxgloveSession::add_message(const FoxgloveMessage& message, Frames& frames) {
  const auto found = subscriptions_.find(message.channel);
  if (found == subscriptions_.end() || message.number <= found->second.last_sent) {
    return;
  }
  Subscription& subscription = found->second;
  subscription.last_sent = message.number;
  FoxgloveFrame frame{
      false,
      {},
      subscription.is_picture ? FoxgloveDelivery::kNewest : FoxgloveDelivery::kLossy,
      message.channel};
  frame.bytes.reserve(kMessageHeadBytes + message.data.size());
  append_little_endian(frame.bytes, kMessageDataOpcode);
  append_little_endian(frame.bytes, subscription.id);
  append_little_endian(frame.bytes, message.log_time_ns);
  frame.bytes.append(message.data.begin(), message.data.end());
  frames.push_back(std::move(frame));
}

}  // namespace echomap::live_page

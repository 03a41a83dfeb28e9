// SPDX-License-Identifier: MIT
#include "host/fleet/publications.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace echomap::fleet {
namespace {

/// Of a PUBLISH packet (MQTT 5, 3.3): type, remaining length, topic length, packet id, properties.
constexpr std::size_t kPacketBytes = 1 + 2 + 2 + 2 + 1;
/// Behind all that is new.
constexpr double kRestoredPatienceS = 12.0;

}  // namespace

Publications::Publications(const FleetExchangeParams& params)
    : compare_after_s_(params.compare_after_s),
      confirm_within_s_(params.confirm_within_s),
      answer_period_s_(params.answer_period_s),
      budget_(params.bytes_per_s, params.burst_bytes) {}

void Publications::put(const fleet_messages::FleetTopic& topic,
                       PublicationContent content,
                       double patience_s,
                       double now_s) {
  Entry& entry = entries_[fleet_messages::format_topic(topic)];
  entry.content = std::move(content);
  entry.delivery = topic.kind == fleet_messages::TopicKind::kPose ? mqtt::Delivery::kAtMostOnce
                                                                  : mqtt::Delivery::kAtLeastOnce;
  entry.kind = topic.kind;
  entry.is_retained = fleet_messages::is_retained(topic.kind);
  entry.is_changed = true;
  entry.is_confirmed = false;
  entry.is_withdrawn = false;
  entry.patience_s = patience_s;
  let_wait(entry, now_s);
}

void Publications::restore(const fleet_messages::FleetTopic& topic, std::string payload) {
  Entry& entry = entries_[fleet_messages::format_topic(topic)];
  entry.kind = topic.kind;
  entry.content = payload;
  entry.payload = std::move(payload);
  entry.is_retained = true;
  entry.is_restored = true;
  entry.patience_s = kRestoredPatienceS;
  entry.sent_s = std::numeric_limits<double>::lowest();
}

bool Publications::repeat(const std::string& topic, double now_s) {
  const auto found = entries_.find(topic);
  if (found == entries_.end() || found->second.is_withdrawn) {
    return false;
  }
  Entry& entry = found->second;
  if (!entry.sent_s || now_s >= *entry.sent_s + answer_period_s_) {
    let_wait(entry, now_s);
  }
  return true;
}

void Publications::repeat_all(bool (*is_wanted)(fleet_messages::TopicKind), double now_s) {
  for (const auto& [topic, entry] : entries_) {
    if (is_wanted(entry.kind)) {
      repeat(topic, now_s);
    }
  }
}

void Publications::withdraw(const std::string& topic, double now_s) {
  const auto found = entries_.find(topic);
  if (found != entries_.end() && !found->second.is_withdrawn) {
    found->second.is_withdrawn = true;
    let_wait(found->second, now_s);
  }
}

void Publications::confirm(const std::string& topic, std::string_view payload) {
  const auto found = entries_.find(topic);
  if (found == entries_.end() || found->second.is_withdrawn || payload != found->second.payload) {
    return;
  }
  found->second.is_confirmed = true;
  if (!found->second.is_changed) {
    found->second.is_waiting = false;
  }
}

void Publications::on_connected(double now_s) {
  connected_s_ = now_s;
  for (auto& [topic, entry] : entries_) {
    entry.is_confirmed = false;
  }
}

void Publications::compare(double now_s) {
  for (auto& [topic, entry] : entries_) {
    if (!entry.is_retained || entry.is_waiting || entry.is_confirmed || !entry.sent_s) {
      continue;
    }
    const double expected_s = *entry.sent_s < connected_s_ ? connected_s_ + compare_after_s_
                                                           : *entry.sent_s + confirm_within_s_;
    if (now_s >= expected_s) {
      let_wait(entry, now_s);
      ++statistics_.published_again;
    }
  }
}

void Publications::send(mqtt::MessageBus& bus, const Encode& encode, double now_s) {
  budget_.advance_to(now_s);
  while (budget_.has_some()) {
    const auto next = most_urgent();
    if (next == entries_.end()) {
      return;
    }
    auto& [topic, entry] = *next;
    entry.is_waiting = false;
    if (!prepare(entry, encode) ||
        !bus.publish(topic, entry.payload, entry.delivery, entry.is_retained)) {
      ++statistics_.too_large;
      entries_.erase(next);
      continue;
    }
    const std::size_t bytes = kPacketBytes + topic.size() + entry.payload.size();
    budget_.spend(bytes);
    statistics_.bytes += bytes;
    ++statistics_.messages;
    entry.sent_s = now_s;
    if (!entry.is_retained || entry.is_withdrawn) {
      entries_.erase(next);
    }
  }
}

std::size_t Publications::waiting() const {
  return static_cast<std::size_t>(std::count_if(
      entries_.begin(), entries_.end(), [](const auto& entry) { return entry.second.is_waiting; }));
}

std::size_t Publications::unconfirmed() const {
  return static_cast<std::size_t>(
      std::count_if(entries_.begin(), entries_.end(), [](const auto& entry) {
        return entry.second.is_retained && !entry.second.is_confirmed;
      }));
}

std::vector<fleet_messages::ContentHash> Publications::sent_hashes(
    bool (*is_wanted)(fleet_messages::TopicKind)) const {
  std::vector<fleet_messages::ContentHash> hashes;
  for (const auto& [topic, entry] : entries_) {
    if (is_wanted(entry.kind) && !entry.is_restored && !entry.payload.empty()) {
      hashes.push_back(fleet_messages::content_hash(entry.payload));
    }
  }
  return hashes;
}

void Publications::let_wait(Entry& entry, double now_s) {
  const double due_s = now_s + entry.patience_s;
  entry.due_s = entry.is_waiting ? std::min(entry.due_s, due_s) : due_s;
  entry.is_waiting = true;
}

Publications::Entries::iterator Publications::most_urgent() {
  auto best = entries_.end();
  for (auto at = entries_.begin(); at != entries_.end(); ++at) {
    if (at->second.is_waiting &&
        (best == entries_.end() || at->second.due_s < best->second.due_s)) {
      best = at;
    }
  }
  return best;
}

bool Publications::prepare(Entry& entry, const Encode& encode) {
  if (entry.is_withdrawn) {
    entry.payload.clear();
    return true;
  }
  if (!entry.is_changed) {
    return true;
  }
  const auto* body = std::get_if<fleet_messages::MessageBody>(&entry.content);
  auto payload =
      body == nullptr ? std::optional(std::get<std::string>(entry.content)) : encode(*body);
  if (payload) {
    entry.payload = std::move(*payload);
    entry.is_changed = false;
    entry.is_restored = false;
  }
  return payload.has_value();
}

}  // namespace echomap::fleet

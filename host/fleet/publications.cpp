// SPDX-License-Identifier: MIT
#include "host/fleet/publications.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace echomap::fleet {
namespace {

/// Of a PUBLISH packet (MQTT 5, 3.3): type, remaining length, topic length, packet id, properties.
constexpr std::size_t kPacketBytes = 1 + 2 + 2 + 2 + 1;
/// Shares of the budget where messages of every worth wait.
constexpr std::array<double, kWorths> kWeights{8.0, 4.0, 2.0, 1.0};

}  // namespace

Publications::Publications(const FleetExchangeParams& params)
    : compare_after_s_(params.compare_after_s),
      confirm_within_s_(params.confirm_within_s),
      answer_period_s_(params.answer_period_s),
      budget_(params.bytes_per_s, params.burst_bytes) {}

void Publications::put(const fleet_messages::FleetTopic& topic,
                       PublicationContent content,
                       Worth worth) {
  const std::string text = fleet_messages::format_topic(topic);
  Entry& entry = entries_[text];
  stop_waiting(entry);
  entry.content = std::move(content);
  entry.kind = topic.kind;
  entry.delivery = topic.kind == fleet_messages::TopicKind::kPose ? mqtt::Delivery::kAtMostOnce
                                                                  : mqtt::Delivery::kAtLeastOnce;
  entry.worth = worth;
  entry.is_retained = fleet_messages::is_retained(topic.kind);
  entry.is_changed = true;
  entry.is_confirmed = false;
  entry.is_withdrawn = false;
  let_wait(text, entry);
}

void Publications::restore(const fleet_messages::FleetTopic& topic,
                           PublicationContent content,
                           std::string payload,
                           Worth worth) {
  Entry& entry = entries_[fleet_messages::format_topic(topic)];
  entry.kind = topic.kind;
  entry.content = std::move(content);
  entry.payload = std::move(payload);
  entry.worth = worth;
  entry.is_retained = true;
  entry.is_restored = true;
  entry.sent_s = std::numeric_limits<double>::lowest();
}

bool Publications::repeat(const std::string& topic, double now_s) {
  const auto found = entries_.find(topic);
  if (found == entries_.end() || found->second.is_withdrawn) {
    return false;
  }
  Entry& entry = found->second;
  if (!entry.sent_s || now_s >= *entry.sent_s + answer_period_s_) {
    let_wait(topic, entry);
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

void Publications::resend() {
  for (auto& [topic, entry] : entries_) {
    if (std::holds_alternative<fleet_messages::MessageBody>(entry.content) && !entry.is_withdrawn) {
      entry.is_changed = true;
      entry.is_confirmed = false;
      let_wait(topic, entry);
    }
  }
}

void Publications::withdraw(const std::string& topic) {
  const auto found = entries_.find(topic);
  if (found != entries_.end() && !found->second.is_withdrawn) {
    found->second.is_withdrawn = true;
    let_wait(topic, found->second);
  }
}

void Publications::confirm(const std::string& topic, std::string_view payload) {
  const auto found = entries_.find(topic);
  if (found == entries_.end() || found->second.is_withdrawn || payload != found->second.payload) {
    return;
  }
  found->second.is_confirmed = true;
  if (!found->second.is_changed) {
    stop_waiting(found->second);
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
    if (!entry.is_retained || entry.place != 0 || entry.is_confirmed || !entry.sent_s) {
      continue;
    }
    const double expected_s = *entry.sent_s < connected_s_ ? connected_s_ + compare_after_s_
                                                           : *entry.sent_s + confirm_within_s_;
    if (now_s >= expected_s) {
      let_wait(topic, entry);
      ++statistics_.published_again;
    }
  }
}

void Publications::send(mqtt::MessageBus& bus, const Encode& encode, double now_s) {
  budget_.advance_to(now_s);
  while (budget_.has_some()) {
    Queue* queue = next_queue();
    if (queue == nullptr) {
      return;
    }
    const std::string topic = queue->topics.begin()->second;
    Entry& entry = entries_.at(topic);
    stop_waiting(entry);
    if (!prepare(entry, encode) ||
        !bus.publish(topic, entry.payload, entry.delivery, entry.is_retained)) {
      ++statistics_.too_large;
      entries_.erase(topic);
      continue;
    }
    entry.sent_s = now_s;
    note_sent(*queue, topic, entry);
    if (!entry.is_retained || entry.is_withdrawn) {
      entries_.erase(topic);
    }
  }
}

void Publications::note_sent(Queue& queue, const std::string& topic, const Entry& entry) {
  const std::size_t bytes = kPacketBytes + topic.size() + entry.payload.size();
  queue.virtual_bytes +=
      static_cast<double>(bytes) / kWeights[static_cast<std::size_t>(entry.worth)];
  budget_.spend(bytes);
  statistics_.bytes += bytes;
  ++statistics_.messages;
}

std::size_t Publications::waiting() const {
  return std::accumulate(
      queues_.begin(), queues_.end(), std::size_t{0}, [](std::size_t sum, const Queue& queue) {
        return sum + queue.topics.size();
      });
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

void Publications::let_wait(const std::string& topic, Entry& entry) {
  if (entry.place != 0) {
    return;
  }
  Queue& queue = queues_[static_cast<std::size_t>(entry.worth)];
  if (queue.topics.empty()) {
    // What it has not used while nothing waited is not saved up.
    const Queue* busiest = next_queue();
    queue.virtual_bytes =
        std::max(queue.virtual_bytes, busiest == nullptr ? 0.0 : busiest->virtual_bytes);
  }
  entry.place = ++last_place_;
  queue.topics.emplace(entry.place, topic);
}

void Publications::stop_waiting(Entry& entry) {
  queues_[static_cast<std::size_t>(entry.worth)].topics.erase(entry.place);
  entry.place = 0;
}

Publications::Queue* Publications::next_queue() {
  Queue* next = nullptr;
  for (Queue& queue : queues_) {
    if (!queue.topics.empty() && (next == nullptr || queue.virtual_bytes < next->virtual_bytes)) {
      next = &queue;
    }
  }
  return next;
}

bool Publications::prepare(Entry& entry, const Encode& encode) {
  if (entry.is_withdrawn) {
    entry.payload.clear();
    return true;
  }
  const auto* body = std::get_if<fleet_messages::MessageBody>(&entry.content);
  // An old boot id would be refused.
  const bool is_outdated = entry.is_restored && body != nullptr;
  if (!entry.is_changed && !is_outdated) {
    return true;
  }
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

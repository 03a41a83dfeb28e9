// SPDX-License-Identifier: MIT
#include "host/mqtt/outbox.hpp"

#include <algorithm>
#include <utility>

namespace echomap::mqtt {
namespace {

std::size_t bytes_of(const OutgoingMessage& message) {
  return message.topic.size() + message.payload.size();
}

}  // namespace

std::size_t Outbox::push(const std::string& topic, std::string_view payload, bool retain) {
  if (retain) {
    const auto older =
        std::find_if(first_waiting(), messages_.end(), [&](const OutgoingMessage& message) {
          return message.retain && message.topic == topic;
        });
    if (older != messages_.end()) {
      take(older);
    }
  }
  const std::size_t bytes = topic.size() + payload.size();
  std::size_t dropped = 0;
  while (messages_.size() + 1 > params_.max_messages || bytes_ + bytes > params_.max_bytes) {
    ++dropped;
    if (next() == nullptr) {
      return dropped;
    }
    drop_next();
  }
  messages_.push_back({topic, std::string(payload), retain, 0});
  bytes_ += bytes;
  return dropped;
}

const OutgoingMessage* Outbox::next() const {
  return sent_ < messages_.size() ? &messages_[sent_] : nullptr;
}

void Outbox::note_sent(int packet_id) {
  first_waiting()->packet_id = packet_id;
  ++sent_;
}

std::optional<OutgoingMessage> Outbox::take_answered(int packet_id) {
  const auto answered =
      std::find_if(messages_.begin(), first_waiting(), [&](const OutgoingMessage& message) {
        return message.packet_id == packet_id;
      });
  if (answered == first_waiting()) {
    return std::nullopt;
  }
  --sent_;
  return take(answered);
}

void Outbox::drop_next() { take(first_waiting()); }

OutgoingMessage Outbox::take(const Iterator& message) {
  OutgoingMessage taken = std::move(*message);
  bytes_ -= bytes_of(taken);
  messages_.erase(message);
  return taken;
}

}  // namespace echomap::mqtt

// SPDX-License-Identifier: MIT
#include "tests/support/memory_bus.hpp"

#include <algorithm>
#include <stdexcept>

namespace echomap::tests {
namespace {

/// As much as a connection keeps while there is none.
constexpr std::size_t kMaxUnsent = 10000;

/// Cuts the part before the next slash off `levels`; empty when none is left.
std::optional<std::string_view> next_level(std::optional<std::string_view>& levels) {
  if (!levels) {
    return std::nullopt;
  }
  const std::size_t slash = levels->find('/');
  const std::string_view level = levels->substr(0, slash);
  if (slash == std::string_view::npos) {
    levels.reset();
  } else {
    levels->remove_prefix(slash + 1);
  }
  return level;
}

}  // namespace

bool topic_matches(std::string_view filter, std::string_view topic) {
  if (topic.starts_with('$') && !filter.starts_with('$')) {
    return false;
  }
  std::optional<std::string_view> filter_levels = filter;
  std::optional<std::string_view> topic_levels = topic;
  for (;;) {
    const auto pattern = next_level(filter_levels);
    if (pattern == "#") {
      return true;
    }
    const auto level = next_level(topic_levels);
    if (!pattern || !level) {
      return pattern == level;
    }
    if (*pattern != "+" && *pattern != *level) {
      return false;
    }
  }
}

MemoryBroker::MemoryBroker(const MemoryBrokerParams& params)
    : params_(params), random_(params.seed) {}

std::unique_ptr<MemoryBus> MemoryBroker::client(const std::string& name,
                                                std::optional<mqtt::LastWill> will) {
  return std::make_unique<MemoryBus>(*this, name, std::move(will));
}

void MemoryBroker::cut(const std::string& name) {
  MemoryBus& client = *clients_.at(name);
  client.is_cut_ = true;
  client.drop_connection();
  if (client.will_) {
    accept(name,
           client.will_->topic,
           client.will_->payload,
           mqtt::Delivery::kAtLeastOnce,
           client.will_->retain);
  }
}

void MemoryBroker::resume(const std::string& name) { clients_.at(name)->is_cut_ = false; }

void MemoryBroker::restart(double lost_share) {
  for (const auto& [name, client] : clients_) {
    client->drop_connection();
  }
  std::erase_if(retained_, [&](const auto&) { return happens(lost_share); });
}

std::size_t MemoryBroker::published_bytes(const std::string& name) const {
  const auto found = published_bytes_.find(name);
  return found == published_bytes_.end() ? 0 : found->second;
}

void MemoryBroker::join(MemoryBus& client) {
  if (!clients_.emplace(client.name_, &client).second) {
    throw std::logic_error("a broker in memory has one client " + client.name_);
  }
}

void MemoryBroker::leave(MemoryBus& client) {
  if (client.is_connected_) {
    cut(client.name_);
  }
  clients_.erase(client.name_);
}

void MemoryBroker::accept(const std::string& from,
                          const std::string& topic,
                          std::string_view payload,
                          mqtt::Delivery delivery,
                          bool retain) {
  published_bytes_[from] += topic.size() + payload.size();
  if (retain && payload.empty()) {
    retained_.erase(topic);
  } else if (retain) {
    retained_[topic] = payload;
  }
  for (const auto& [name, client] : clients_) {
    const bool hears = std::ranges::any_of(
        client->filters_, [&](const std::string& filter) { return topic_matches(filter, topic); });
    if (client->is_connected_ && hears) {
      deliver(*client, {topic, std::string(payload), false}, delivery);
    }
  }
}

void MemoryBroker::deliver(MemoryBus& client, mqtt::Message message, mqtt::Delivery delivery) {
  if (happens(params_.loss_share)) {
    ++lost_;
    return;
  }
  const double earliest_s = client.due_.empty() ? now_s_ : client.due_.back().at_s;
  const double at_s = std::max(earliest_s, now_s_ + even() * params_.max_delay_s);
  if (delivery == mqtt::Delivery::kAtLeastOnce && happens(params_.repeat_share)) {
    client.due_.push_back({at_s, message});
  }
  client.due_.push_back({at_s, std::move(message)});
}

void MemoryBroker::send_retained(MemoryBus& client, const std::string& filter) {
  for (const auto& [topic, payload] : retained_) {
    if (topic_matches(filter, topic)) {
      deliver(client, {topic, payload, true}, mqtt::Delivery::kAtLeastOnce);
    }
  }
}

MemoryBus::MemoryBus(MemoryBroker& broker, std::string name, std::optional<mqtt::LastWill> will)
    : broker_(broker), name_(std::move(name)), will_(std::move(will)) {
  if (broker.clients_.contains(name_)) {
    throw std::logic_error("a memory bus has one client " + name_);
  }
  broker_.join(*this);
}

MemoryBus::~MemoryBus() { broker_.leave(*this); }

bool MemoryBus::publish(const std::string& topic,
                        std::string_view payload,
                        mqtt::Delivery delivery,
                        bool retain) {
  if (payload.size() > broker_.params_.max_payload_bytes) {
    return false;
  }
  if (is_connected_) {
    broker_.accept(name_, topic, payload, delivery, retain);
  } else if (delivery == mqtt::Delivery::kAtLeastOnce && unsent_.size() < kMaxUnsent) {
    unsent_.push_back({topic, std::string(payload), retain});
  }
  return true;
}

void MemoryBus::subscribe(const std::string& filter) {
  if (std::ranges::find(filters_, filter) == filters_.end()) {
    filters_.push_back(filter);
  }
  if (is_connected_) {
    broker_.send_retained(*this, filter);
  }
}

std::vector<mqtt::Message> MemoryBus::take() {
  if (!is_connected_ && !is_cut_) {
    connect();
  }
  std::vector<mqtt::Message> taken;
  while (!due_.empty() && due_.front().at_s <= broker_.now_s_) {
    taken.push_back(std::move(due_.front().message));
    due_.pop_front();
  }
  return taken;
}

void MemoryBus::connect() {
  is_connected_ = true;
  ++connections_;
  for (const std::string& filter : filters_) {
    broker_.send_retained(*this, filter);
  }
  for (const Unsent& message : std::exchange(unsent_, {})) {
    broker_.accept(
        name_, message.topic, message.payload, mqtt::Delivery::kAtLeastOnce, message.retain);
  }
}

void MemoryBus::drop_connection() {
  is_connected_ = false;
  due_.clear();
}

void MemoryBus::disconnect() {
  is_cut_ = true;
  drop_connection();
}

}  // namespace echomap::tests

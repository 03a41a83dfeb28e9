// SPDX-License-Identifier: MIT
#include "host/live_page/history.hpp"

namespace echomap::live_page {
namespace {

constexpr double kMotionPeriodS = 0.1;
constexpr double kParticlesPeriodS = 1.0;

/// In which a client that connects gets the newest of each kind.
constexpr MessageKind kOrder[] = {MessageKind::kHello,
                                  MessageKind::kTile,
                                  MessageKind::kTrail,
                                  MessageKind::kRoom,
                                  MessageKind::kParticles,
                                  MessageKind::kState,
                                  MessageKind::kTeam,
                                  MessageKind::kMotion};

}  // namespace

void History::add(const SharedMessage& message) {
  Listener listener;
  {
    const std::lock_guard lock(mutex_);
    if (message->kind == MessageKind::kNewMap) {
      std::erase_if(newest_, [](const auto& entry) {
        const MessageKind kind = entry.first.first;
        return kind == MessageKind::kTile || kind == MessageKind::kTrail ||
               kind == MessageKind::kRoom || kind == MessageKind::kParticles;
      });
    }
    if (is_kept(*message)) {
      kept_bytes_ += message->bytes.size();
      kept_.push_back(message);
    }
    if (message->is_state()) {
      newest_[{message->kind, message->key}] = message;
    }
    listener = listener_;
  }
  if (listener) {
    listener(message);
  }
}

void History::listen(Listener listener) {
  const std::lock_guard lock(mutex_);
  listener_ = std::move(listener);
}

std::vector<SharedMessage> History::newest() const {
  const std::lock_guard lock(mutex_);
  std::vector<SharedMessage> messages;
  messages.reserve(newest_.size());
  for (const MessageKind kind : kOrder) {
    for (auto it = newest_.lower_bound({kind, 0}); it != newest_.end() && it->first.first == kind;
         ++it) {
      messages.push_back(it->second);
    }
  }
  return messages;
}

std::vector<SharedMessage> History::since(std::size_t first) const {
  const std::lock_guard lock(mutex_);
  if (first >= kept_.size()) {
    return {};
  }
  return {kept_.begin() + static_cast<std::ptrdiff_t>(first), kept_.end()};
}

bool History::is_kept(const Message& message) {
  if (message.is_state() && kept_bytes_ > kMaxBytes) {
    return false;
  }
  const bool is_motion = message.kind == MessageKind::kMotion;
  if (!is_motion && message.kind != MessageKind::kParticles) {
    return true;
  }
  double& next_s = is_motion ? next_motion_s_ : next_particles_s_;
  if (message.time_s < next_s) {
    return false;
  }
  next_s = message.time_s + (is_motion ? kMotionPeriodS : kParticlesPeriodS);
  return true;
}

}  // namespace echomap::live_page

// SPDX-License-Identifier: MIT
#include "host/fleet/relays.hpp"

#include <algorithm>

namespace echomap::fleet {

using fleet_messages::TopicKind;

namespace {

bool is_requested(const fleet_messages::AskMessage& request,
                  const fleet_messages::FleetTopic& topic) {
  const auto* hash = std::get_if<fleet_messages::ContentHash>(&topic.id);
  return hash == nullptr ? request.everything_else == 1
                         : std::find(request.objects.begin(), request.objects.end(), *hash) !=
                               request.objects.end();
}

}  // namespace

Relays::Relays(const FleetExchangeParams& params)
    : fleet_(params.fleet),
      robot_(params.robot),
      gone_after_s_(params.gone_after_s),
      step_s_(params.relay_step_s) {}

void Relays::note(const ReceivedRequest& received, const FleetKnowledge& knowledge, double now_s) {
  for (const auto& [topic, stored] : knowledge.stored(received.request.robot)) {
    const auto parsed = fleet_messages::parse_topic(topic);
    if (parsed && is_requested(received.request, *parsed)) {
      requested_s_.emplace(topic, now_s);
    }
  }
}

void Relays::update(const FleetKnowledge& knowledge, Publications& publications, double now_s) {
  const double wait_s = step_s_ * rank(knowledge, now_s);
  const bool knows_broker = now_s >= connected_s_ + gone_after_s_ + wait_s;
  for (const auto& [author, robot] : knowledge.robots()) {
    if (author == robot_ || knowledge.is_alive(author, now_s)) {
      continue;
    }
    for (const auto& [topic, stored] : knowledge.stored(author)) {
      if (!is_passed_on(stored.kind)) {
        continue;
      }
      const auto requested = requested_s_.find(topic);
      const bool is_due = requested != requested_s_.end() && now_s >= requested->second + wait_s;
      const bool is_unanswered = is_due && stored.last_received_s < requested->second;
      if (is_unanswered || (knows_broker && stored.last_received_s < connected_s_)) {
        pass_on(author, stored, publications, now_s);
      }
      if (is_due) {
        requested_s_.erase(requested);
      }
    }
  }
  std::erase_if(authors_, [&](const auto& relay) {
    const bool is_back = knowledge.is_alive(relay.second, now_s);
    if (is_back) {
      publications.withdraw(relay.first);
    }
    return is_back;
  });
}

int Relays::rank(const FleetKnowledge& knowledge, double now_s) const {
  int before = 0;
  for (const auto& [name, robot] : knowledge.robots()) {
    before += name < robot_ && knowledge.is_alive(name, now_s) ? 1 : 0;
  }
  return before;
}

void Relays::pass_on(const std::string& author,
                     const StoredPayload& stored,
                     Publications& publications,
                     double now_s) {
  const fleet_messages::FleetTopic topic{
      fleet_, robot_, TopicKind::kRelay, fleet_messages::content_hash(stored.payload)};
  const std::string text = fleet_messages::format_topic(topic);
  if (!publications.repeat(text, now_s)) {
    publications.put(topic, stored.payload, Worth::kRelay);
    ++count_;
  }
  authors_[text] = author;
}

}  // namespace echomap::fleet

// SPDX-License-Identifier: MIT
#include "host/fleet/relays.hpp"

#include <algorithm>

namespace echomap::fleet {

using fleet_messages::TopicKind;

namespace {

bool is_asked_for(const fleet_messages::AskMessage& ask, const fleet_messages::FleetTopic& topic) {
  const auto* hash = std::get_if<fleet_messages::ContentHash>(&topic.id);
  return hash == nullptr
             ? ask.everything_else == 1
             : std::find(ask.objects.begin(), ask.objects.end(), *hash) != ask.objects.end();
}

}  // namespace

Relays::Relays(const FleetExchangeParams& params)
    : fleet_(params.fleet),
      robot_(params.robot),
      gone_after_s_(params.gone_after_s),
      step_s_(params.relay_step_s) {}

void Relays::note(const HeardAsk& heard, const FleetKnowledge& knowledge, double now_s) {
  for (const auto& [topic, stored] : knowledge.stored(heard.ask.robot)) {
    const auto parsed = fleet_messages::parse_topic(topic);
    if (parsed && is_asked_for(heard.ask, *parsed)) {
      asked_s_.emplace(topic, now_s);
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
      const auto asked = asked_s_.find(topic);
      const bool is_due = asked != asked_s_.end() && now_s >= asked->second + wait_s;
      const bool is_asked_in_vain = is_due && stored.heard_s < asked->second;
      if (is_asked_in_vain || (knows_broker && stored.heard_s < connected_s_)) {
        pass_on(author, stored, publications, now_s);
      }
      if (is_due) {
        asked_s_.erase(asked);
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

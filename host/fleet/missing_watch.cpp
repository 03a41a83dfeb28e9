// SPDX-License-Identifier: MIT
#include "host/fleet/missing_watch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace echomap::fleet {

using fleet_messages::AskMessage;
using fleet_messages::ContentHash;

namespace {

/// Largest number of objects in one request: half a kilobyte.
constexpr std::size_t kMaxRequestedObjects = 32;
/// How often the time between requests doubles while no answer comes.
constexpr int kMaxDoublings = 4;

bool misses_manifest(const RobotKnowledge& robot, const std::vector<ContentHash>& promised) {
  const auto& presence = robot.presence();
  return presence && promised.size() < presence->own_objects;
}

}  // namespace

MissingWatch::MissingWatch(const FleetExchangeParams& params)
    : robot_(params.robot),
      request_after_s_(params.request_after_s),
      request_period_s_(params.request_period_s) {}

std::optional<AskMessage> MissingWatch::next(const FleetKnowledge& knowledge, double now_s) {
  for (const auto& [name, robot] : knowledge.robots()) {
    if (name == robot_) {
      continue;
    }
    look(robot, knowledge, now_s);
    Watched& watched = watched_[name];
    AskMessage request = request_for(name, watched, now_s);
    const bool misses_some = request.everything_else == 1 || !request.objects.empty();
    if (misses_some && may_request(watched, now_s)) {
      watched.requested_s = now_s;
      ++watched.unanswered_requests;
      return request;
    }
  }
  return std::nullopt;
}

void MissingWatch::look(const RobotKnowledge& robot,
                        const FleetKnowledge& knowledge,
                        double now_s) {
  Watched& watched = watched_[robot.name()];
  const std::vector<ContentHash> promised = robot.promised();
  std::map<ContentHash, double> missing;
  for (const ContentHash& object : promised) {
    if (!knowledge.has(object)) {
      const auto since = watched.objects.find(object);
      missing[object] = since == watched.objects.end() ? now_s : since->second;
    }
  }
  const bool misses_rest =
      misses_manifest(robot, promised) ||
      (knowledge.is_alive(robot.name(), now_s) && knowledge.is_behind(robot.name()));
  if (missing.size() < watched.objects.size() || (watched.rest_since_s && !misses_rest)) {
    watched.unanswered_requests = 0;
  }
  watched.objects = std::move(missing);
  if (!misses_rest) {
    watched.rest_since_s.reset();
  } else if (!watched.rest_since_s) {
    watched.rest_since_s = now_s;
  }
}

bool MissingWatch::may_request(const Watched& watched, double now_s) const {
  const int doublings = std::min(watched.unanswered_requests, kMaxDoublings + 1) - 1;
  return !watched.requested_s ||
         now_s >= *watched.requested_s + std::ldexp(request_period_s_, doublings);
}

AskMessage MissingWatch::request_for(const std::string& robot,
                                     const Watched& watched,
                                     double now_s) const {
  AskMessage request{robot, 0, {}};
  if (watched.rest_since_s && now_s >= *watched.rest_since_s + request_after_s_) {
    request.everything_else = 1;
  }
  for (const auto& [object, since_s] : watched.objects) {
    if (now_s >= since_s + request_after_s_ && request.objects.size() < kMaxRequestedObjects) {
      request.objects.push_back(object);
    }
  }
  return request;
}

}  // namespace echomap::fleet

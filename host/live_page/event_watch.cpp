// SPDX-License-Identifier: MIT
#include "host/live_page/event_watch.hpp"

#include <utility>

namespace echomap::live_page {
namespace {

using Level = RunEvent::Level;
using robot_link::LinkState;
using session::StandReason;

void tell_link(const EventFacts& before, const EventFacts& now, std::vector<RunEvent>& events) {
  if (now.resets > before.resets) {
    events.push_back(
        {"reset",
         Level::kWarning,
         "the robot has started anew and is set up again",
         "its supply dips when the motors start, its watchdog bit, or its port was "
         "opened by another program",
         "fresh batteries, a capacitor across the motors' supply; one program a port"});
  }
  const bool was_ready = before.link == LinkState::kReady;
  const bool is_ready = now.link == LinkState::kReady;
  if (was_ready && !is_ready) {
    events.push_back({"link-lost",
                      Level::kError,
                      "the link to the robot is lost; its wheels stop by themselves",
                      "the cable or the radio, or the board has no power",
                      "plug it in again: the run goes on by itself"});
  } else if (!was_ready && is_ready) {
    events.push_back({"link-ready", Level::kInfo, "the robot answers"});
  }
}

void tell_robot(const EventFacts& before, const EventFacts& now, std::vector<RunEvent>& events) {
  if (now.is_lifted && !before.is_lifted) {
    events.push_back({"lifted",
                      Level::kWarning,
                      "the robot was picked up: it may be put down anywhere",
                      "a wheel hangs, or there is no floor under it",
                      "put it down; it looks for its place"});
  } else if (now.is_touching && !before.is_touching) {
    events.push_back({"bumped",
                      Level::kInfo,
                      "it touched something, which is now in the map",
                      "too low, too thin or too soft for the sonar",
                      ""});
  }
}

void tell_parts(const EventFacts& before, const EventFacts& now, std::vector<RunEvent>& events) {
  if (now.sonar_is_dead && !before.sonar_is_dead) {
    events.push_back({"sonar-dead",
                      Level::kError,
                      "the sonar does not answer",
                      "it is not connected, it has no supply, or it is dead",
                      "check its four wires and its 5 V"});
  } else if (!now.sonar_is_dead && before.sonar_is_dead) {
    events.push_back({"sonar-answers", Level::kInfo, "the sonar answers again"});
  }
  if (now.left_encoder_is_dirty && !before.left_encoder_is_dirty) {
    events.push_back({"encoder-left-dirty",
                      Level::kWarning,
                      "the left encoder loses counts, so odometry is wrong",
                      "dirt on its disc, a disc that is not true, a loose wire",
                      "clean it, set its distance, check its wires and its supply"});
  }
  if (now.right_encoder_is_dirty && !before.right_encoder_is_dirty) {
    events.push_back({"encoder-right-dirty",
                      Level::kWarning,
                      "the right encoder loses counts, so odometry is wrong",
                      "dirt on its disc, a disc that is not true, a loose wire",
                      "clean it, set its distance, check its wires and its supply"});
  }
}

void tell_maps(const EventFacts& before, const EventFacts& now, std::vector<RunEvent>& events) {
  if (now.maps_joined > before.maps_joined) {
    events.push_back({"maps-joined",
                      Level::kInfo,
                      "it has found its place in the earlier map; the two maps are one again"});
  } else if (now.maps_changed > before.maps_changed) {
    events.push_back({"new-map",
                      Level::kWarning,
                      "what it hears is not what its map has there: it begins a new map",
                      "it was carried off, or a wheel has slipped",
                      "nothing to do: the earlier map is kept, and joined once it is recognized"});
  }
}

void tell_person(const EventFacts& before, const EventFacts& now, std::vector<RunEvent>& events) {
  if (now.stands == before.stands) {
    return;
  }
  switch (now.stands) {
    case StandReason::kStopPressed:
      events.push_back({"stop", Level::kInfo, "STOP was pressed"});
      break;
    case StandReason::kDriverGone:
    case StandReason::kDriverSilent:
      events.push_back({"driver-gone",
                        Level::kWarning,
                        "stopped: the page that drove it is silent",
                        "its tab was closed or hidden, or its connection is slow or gone",
                        "drive on, or let it explore"});
      break;
    case StandReason::kNoWay:
      events.push_back({"no-way",
                        Level::kWarning,
                        "no known floor leads there",
                        "the place is unknown, occupied, or behind a gap that it does not fit "
                        "through",
                        "choose a place on free floor"});
      break;
    case StandReason::kStalled:
      events.push_back({"stalled",
                        Level::kError,
                        "the wheels do not turn",
                        "something holds it, or a motor or its supply has failed",
                        "free it, check the batteries and the motors' wires"});
      break;
    default:
      break;
  }
}

}  // namespace

std::vector<RunEvent> EventWatch::look_at(const EventFacts& facts) {
  std::vector<RunEvent> events;
  tell_link(before_, facts, events);
  tell_robot(before_, facts, events);
  tell_parts(before_, facts, events);
  tell_maps(before_, facts, events);
  tell_person(before_, facts, events);
  before_ = facts;
  return events;
}

}  // namespace echomap::live_page

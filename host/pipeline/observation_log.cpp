// SPDX-License-Identifier: MIT
#include "host/pipeline/observation_log.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace echomap::pipeline {

using sensors::BeginScan;
using sensors::EndScan;

void ObservationLog::on(const sensors::Observation& observation) {
  if (const auto* carried = std::get_if<sensors::CarriedObservation>(&observation)) {
    stretches_.push_back({*carried, {}});
    return;
  }
  if (is<sensors::YawObservation>(observation) || is<sensors::BatteryObservation>(observation) ||
      is<sensors::EncoderErrorObservation>(observation) ||
      (is<EndScan>(observation) && !scan_is_open_)) {
    return;
  }
  if (is<BeginScan>(observation)) {
    end_scan();
  }
  scan_is_open_ = is<BeginScan>(observation) || (scan_is_open_ && !is<EndScan>(observation));
  if (stretches_.empty()) {
    stretches_.emplace_back();
  }
  stretches_.back().events.push_back(observation);
}

void ObservationLog::replay(ObservationSink& sink) const {
  for (const Stretch& stretch : stretches_) {
    if (stretch.carried) {
      sink.on_carried(*stretch.carried);
    }
    for (const Event& event : stretch.events) {
      hand_on(event, sink);
    }
  }
}

std::size_t ObservationLog::observations() const {
  std::size_t observations = 0;
  for (const Stretch& stretch : stretches_) {
    observations += stretch.events.size() + (stretch.carried ? 1 : 0);
  }
  return observations;
}

std::size_t ObservationLog::scans() const {
  std::size_t scans = 0;
  for (const Stretch& stretch : stretches_) {
    scans += static_cast<std::size_t>(
        std::count_if(stretch.events.begin(), stretch.events.end(), is<EndScan>));
  }
  return scans;
}

ObservationLog ObservationLog::split_off(std::size_t scans) {
  ObservationLog taken;
  if (stretches_.empty()) {
    return taken;
  }
  std::vector<Event>& events = stretches_.back().events;
  auto first = events.end();
  for (std::size_t i = 0; i < scans; ++i) {
    const auto begin =
        std::find_if(std::make_reverse_iterator(first), events.rend(), is<BeginScan>);
    first = begin == events.rend() ? events.begin() : std::prev(begin.base());
  }
  const auto last_kept =
      std::find_if(std::make_reverse_iterator(first), events.rend(), is<EndScan>).base();
  taken.on_carried(end_of({stretches_.back().carried, {events.begin(), first}}));
  taken.stretches_.back().events.assign(first, events.end());
  events.erase(last_kept, events.end());
  return taken;
}

ObservationLog ObservationLog::split_off_lift() {
  ObservationLog taken;
  if (stretches_.empty()) {
    return taken;
  }
  std::vector<Event>& events = stretches_.back().events;
  taken.on_carried(end_of(stretches_.back()));
  events.erase(std::find_if(events.begin(), events.end(), is_lift), events.end());
  const auto scan = std::find_if(events.rbegin(), events.rend(), [](const Event& event) {
    return is<BeginScan>(event) || is<EndScan>(event);
  });
  if (scan != events.rend() && is<BeginScan>(*scan)) {
    events.erase(std::prev(scan.base()), events.end());
  }
  scan_is_open_ = false;
  return taken;
}

bool ObservationLog::is_lift(const Event& event) {
  const auto* hazards = std::get_if<sensors::HazardObservation>(&event);
  return hazards != nullptr && hazards->is_in_the_air();
}

time::RobotTime ObservationLog::begin_of(const Stretch& stretch) {
  return stretch.carried ? stretch.carried->stamp : time::RobotTime::min();
}

sensors::CarriedObservation ObservationLog::end_of(const Stretch& stretch) {
  sensors::CarriedObservation end;
  if (stretch.carried) {
    end.stamp = stretch.carried->stamp;
    end.travel = stretch.carried->travel;
  }
  const auto take = [&](const auto& observation) {
    if constexpr (requires { observation.stamp; }) {
      end.stamp = std::max(end.stamp, observation.stamp);
    }
    if constexpr (requires { observation.travel; }) {
      end.travel = observation.travel;
    }
  };
  for (const Event& event : stretch.events) {
    std::visit(take, event);
  }
  return end;
}

bool ObservationLog::begins_before(const ObservationLog& other) const {
  return !stretches_.empty() && !other.stretches_.empty() &&
         begin_of(stretches_.front()) < begin_of(other.stretches_.front());
}

ObservationLog joined(ObservationLog one,
                      const ObservationLog& other,
                      const geometry::Pose2& T_one_other) {
  if (other.begins_before(one)) {
    return joined(other, one, T_one_other.inverse());
  }
  for (ObservationLog::Stretch stretch : other.stretches_) {
    if (stretch.carried) {
      stretch.carried->T_map_robot = T_one_other * stretch.carried->T_map_robot;
    }
    for (ObservationLog::Event& event : stretch.events) {
      if (auto* fix = std::get_if<sensors::PoseFixObservation>(&event)) {
        fix->T_map_robot = T_one_other * fix->T_map_robot;
      }
    }
    one.stretches_.push_back(std::move(stretch));
  }
  std::stable_sort(one.stretches_.begin(), one.stretches_.end(), [](const auto& a, const auto& b) {
    return ObservationLog::begin_of(a) < ObservationLog::begin_of(b);
  });
  return one;
}

}  // namespace echomap::pipeline

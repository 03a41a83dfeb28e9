// SPDX-License-Identifier: MIT
#include "host/exports/sweep_times.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "host/geometry/angle.hpp"

namespace echomap::exports {
namespace {

using pipeline::StampedPose;

/// A sweep of fewer readings may be one of a robot that turns.
constexpr std::size_t kManyReadings = 8;
/// The robot is where a sweep was made while it is no farther off.
constexpr double kAtPlaceM = 0.01;
constexpr double kAtPlaceRad = geometry::radians(1.0);
/// A robot that is there for less drives past.
constexpr std::chrono::seconds kMinStay{1};

/// Poses of the trajectory, both included, during which the robot was at one place.
struct Stay {
  std::size_t first = 0;
  std::size_t last = 0;
  bool was_found = false;
};

bool is_at(const geometry::Pose2& T_map_place, const geometry::Pose2& T_map_robot) {
  return (T_map_robot.position_m() - T_map_place.position_m()).norm() <= kAtPlaceM &&
         std::abs(geometry::angle_between(T_map_place.heading_rad(), T_map_robot.heading_rad())) <=
             kAtPlaceRad;
}

/// The first one from pose `from` on; not found where the robot only drives past.
Stay stay_at(const std::vector<StampedPose>& trajectory,
             std::size_t from,
             const geometry::Pose2& T_map_place) {
  std::size_t first = from;
  while (first < trajectory.size()) {
    std::size_t end = first;
    while (end < trajectory.size() && is_at(T_map_place, trajectory[end].T_map_robot)) {
      ++end;
    }
    if (end > first && trajectory[end - 1].stamp - trajectory[first].stamp >= kMinStay) {
      return {first, end - 1, true};
    }
    first = std::max(end, first + 1);
  }
  return {};
}

std::vector<Stay> stays_of(const std::vector<SonarSweep>& sweeps,
                           const std::vector<StampedPose>& trajectory) {
  std::vector<Stay> stays;
  stays.reserve(sweeps.size());
  std::size_t from = 0;
  for (const SonarSweep& sweep : sweeps) {
    const bool is_long = sweep.readings.size() >= kManyReadings;
    stays.push_back(is_long ? stay_at(trajectory, from, sweep.T_map_robot) : Stay{});
    from = std::max(from, stays.back().first);
  }
  return stays;
}

/// From sweep `begin` on, those made in a row during the stay of that one.
std::size_t end_of_stay(const std::vector<Stay>& stays, std::size_t begin) {
  std::size_t end = begin;
  while (end < stays.size() && stays[end].was_found && stays[end].first == stays[begin].first) {
    ++end;
  }
  return end;
}

std::size_t end_without_stay(const std::vector<Stay>& stays, std::size_t begin) {
  std::size_t end = begin;
  while (end < stays.size() && !stays[end].was_found) {
    ++end;
  }
  return end;
}

std::vector<SonarSweep> all_sweeps(const pipeline::Snapshot& snapshot) {
  std::vector<SonarSweep> all;
  for (const mapping::Scan& scan : *snapshot.scans) {
    std::vector<SonarSweep> sweeps = sweeps_of(scan);
    all.insert(all.end(), sweeps.begin(), sweeps.end());
  }
  return all;
}

/// What a sweep takes of the time that it shares.
enum class SweepWeight { kReadings, kEqual };

/// Adds the next sweeps, up to `end`, so that they end one after the other between these poses.
void add_sweeps(std::vector<TimedSweep>& timed,
                std::vector<SonarSweep>& sweeps,
                std::size_t end,
                const Stay& poses,
                SweepWeight weight) {
  const auto weight_of = [&](std::size_t sweep) {
    return weight == SweepWeight::kReadings ? sweeps[sweep].readings.size() : 1;
  };
  std::size_t sum = 0;
  for (std::size_t i = timed.size(); i < end; ++i) {
    sum += weight_of(i);
  }
  std::size_t part = 0;
  for (std::size_t i = timed.size(); i < end; ++i) {
    part += weight_of(i);
    const std::size_t pose =
        poses.first + (poses.last - poses.first) * part / std::max<std::size_t>(sum, 1);
    const std::size_t previous = timed.empty() ? 0 : timed.back().pose;
    timed.push_back({std::move(sweeps[i]), std::max(pose, previous)});
  }
}

}  // namespace

std::vector<TimedSweep> timed_sweeps(const pipeline::Snapshot& snapshot) {
  std::vector<TimedSweep> timed;
  const auto& trajectory = *snapshot.trajectory;
  if (trajectory.empty()) {
    return timed;
  }
  std::vector<SonarSweep> sweeps = all_sweeps(snapshot);
  const auto stays = stays_of(sweeps, trajectory);
  timed.reserve(sweeps.size());
  while (timed.size() < sweeps.size()) {
    const std::size_t begin = timed.size();
    if (stays[begin].was_found) {
      const std::size_t end = end_of_stay(stays, begin);
      add_sweeps(timed, sweeps, end, stays[begin], SweepWeight::kReadings);
    } else {
      const std::size_t end = end_without_stay(stays, begin);
      const std::size_t first = timed.empty() ? 0 : timed.back().pose;
      const std::size_t last = end < stays.size() ? stays[end].first : trajectory.size() - 1;
      add_sweeps(timed, sweeps, end, {first, std::max(first, last), true}, SweepWeight::kEqual);
    }
  }
  return timed;
}

}  // namespace echomap::exports

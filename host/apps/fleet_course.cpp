// SPDX-License-Identifier: MIT
#include "host/apps/fleet_course.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "host/apps/stop_trajectory.hpp"
#include "host/geometry/angle.hpp"
#include "host/team_map/calibrated_submaps.hpp"
#include "host/team_map/merged_map.hpp"
#include "host/team_map/placed_submaps.hpp"
#include "host/team_map/team_map.hpp"

namespace echomap::apps {
namespace {

using fleet_member::LoggedJoin;
using geometry::Pose2;

constexpr double kWrongM = 0.5;
constexpr double kWrongRad = 0.35;
constexpr double kEnoughShare = 0.9;

/// Places the map by all stops that the truth knows. Answers whether there is one.
bool place_by_truth(const std::vector<pipeline::StampedPose>& ends,
                    const std::vector<evaluation::TruePose>& truth,
                    ScoredMap& scored) {
  const auto is_known = [&](const pipeline::StampedPose& end) {
    return evaluation::true_pose_at(truth, end.stamp).has_value();
  };
  if (std::ranges::none_of(ends, is_known)) {
    return false;
  }
  scored.T_world_map = evaluation::fit_aligned(ends, truth);
  double squares_m2 = 0.0;
  int known = 0;
  for (const pipeline::StampedPose& end : ends) {
    if (const auto T_world_end = evaluation::true_pose_at(truth, end.stamp)) {
      const Pose2 T_world_placed = scored.T_world_map * end.T_map_robot;
      squares_m2 += (T_world_placed.position_m() - T_world_end->position_m()).squaredNorm();
      ++known;
    }
  }
  scored.own_error_m = std::sqrt(squares_m2 / known);
  return true;
}

std::vector<bool> free_cells(const mapping::OccupancyGrid& grid,
                             const Pose2& T_world_map,
                             const std::vector<Eigen::Vector2d>& floor_m) {
  const Pose2 T_map_world = T_world_map.inverse();
  std::vector<bool> is_free;
  is_free.reserve(floor_m.size());
  for (const Eigen::Vector2d& center_m : floor_m) {
    is_free.push_back(grid.state(grid.cell_at(T_map_world * center_m)) ==
                      mapping::CellState::kFree);
  }
  return is_free;
}

bool is_of(const ScoredMap& map, const std::string& robot) {
  return map.name.substr(0, map.name.rfind('.')) == robot;
}

/// That which the robot was making at that time; null before its first stop.
const ScoredMap* map_at(const std::vector<ScoredMap>& maps,
                        const std::string& robot,
                        double now_s) {
  const ScoredMap* last = nullptr;
  for (const ScoredMap& map : maps) {
    last = is_of(map, robot) && map.stop_s.front() <= now_s ? &map : last;
  }
  return last;
}

bool is_wrong(const LoggedJoin& join, const std::vector<ScoredMap>& maps) {
  const ScoredMap* own = find_map(maps, join.own_map);
  const ScoredMap* peer = find_map(maps, join.peer_map);
  if (own == nullptr || peer == nullptr) {
    return false;
  }
  const Pose2 T_true = own->T_world_map.inverse() * peer->T_world_map;
  const double off_m = (join.T_own_peer * peer->middle_m - T_true * peer->middle_m).norm();
  const double off_rad = std::abs((T_true.inverse() * join.T_own_peer).heading_rad());
  return off_m > kWrongM || off_rad > kWrongRad;
}

bool holds_at(const LoggedJoin& join, double now_s) {
  return join.from_s <= now_s && (!join.until_s || now_s < *join.until_s);
}

void add_seen(const ScoredMap& map, double now_s, std::vector<bool>& seen) {
  const auto stops = std::upper_bound(map.stop_s.begin(), map.stop_s.end(), now_s);
  if (stops == map.stop_s.begin()) {
    return;
  }
  const auto& of_map = map.seen[static_cast<std::size_t>(stops - map.stop_s.begin()) - 1];
  seen.resize(of_map.size());
  std::transform(seen.begin(), seen.end(), of_map.begin(), seen.begin(), std::logical_or<>());
}

/// Of the floor, what the member's map and those joined to it had.
double member_share(const MemberReport& member, const std::vector<ScoredMap>& maps, double now_s) {
  const ScoredMap* own = map_at(maps, member.robot, now_s);
  if (own == nullptr) {
    return 0.0;
  }
  std::vector<bool> seen;
  add_seen(*own, now_s, seen);
  for (const LoggedJoin& join : member.joins) {
    const ScoredMap* peer = find_map(maps, join.peer_map);
    if (peer != nullptr && join.own_map == own->name && holds_at(join, now_s) &&
        !is_wrong(join, maps)) {
      add_seen(*peer, now_s, seen);
    }
  }
  const auto cells = static_cast<double>(std::ranges::count(seen, true));
  return seen.empty() ? 0.0 : cells / static_cast<double>(seen.size());
}

/// When anything of it changed: stops and joins, in their order.
std::vector<double> times_s(const std::vector<ScoredMap>& maps,
                            const std::vector<MemberReport>& members) {
  std::vector<double> times_s;
  for (const ScoredMap& map : maps) {
    times_s.insert(times_s.end(), map.stop_s.begin(), map.stop_s.end());
  }
  for (const MemberReport& member : members) {
    for (const LoggedJoin& join : member.joins) {
      times_s.push_back(join.from_s);
      if (join.until_s) {
        times_s.push_back(*join.until_s);
      }
    }
  }
  std::ranges::sort(times_s);
  return times_s;
}

std::optional<double> joined_s(const std::vector<ScoredMap>& maps,
                               const std::vector<MemberReport>& members) {
  constexpr double kEnd = std::numeric_limits<double>::infinity();
  const ScoredMap* own = map_at(maps, members.front().robot, kEnd);
  double last_s = 0.0;
  for (auto member = members.begin() + 1; member != members.end(); ++member) {
    const ScoredMap* peer = map_at(maps, member->robot, kEnd);
    const auto& joins = members.front().joins;
    const auto join = std::ranges::find_if(joins, [&](const LoggedJoin& one) {
      return own != nullptr && peer != nullptr && !one.until_s && one.own_map == own->name &&
             one.peer_map == peer->name;
    });
    if (join == joins.end()) {
      return std::nullopt;
    }
    last_s = std::max(last_s, join->from_s);
  }
  return last_s;
}

}  // namespace

const ScoredMap* find_map(const std::vector<ScoredMap>& maps, const std::string& name) {
  const auto found = std::ranges::find(maps, name, &ScoredMap::name);
  return found == maps.end() ? nullptr : &*found;
}

RelativePoseError relative_pose_error(const Pose2& T_own_peer,
                                      const ScoredMap& own,
                                      const ScoredMap& peer) {
  const Pose2 T_true_peer = (own.T_world_map.inverse() * peer.T_world_map).inverse() * T_own_peer;
  return {(T_true_peer * peer.last_m - peer.last_m).norm(),
          std::abs(T_true_peer.heading_rad()),
          own.own_error_m + peer.own_error_m};
}

std::optional<ScoredMap> score_map(const team_map::RobotRecord& record,
                                   const std::vector<evaluation::TruePose>& truth,
                                   const std::vector<Eigen::Vector2d>& floor_m) {
  const std::size_t stops = std::min(record.submaps.size(), record.T_map_submaps.size());
  team_map::CalibratedSubmaps calibrated;
  calibrated.take(record.submaps);
  const std::vector<team_map::Submap>& submaps = calibrated.submaps();
  ScoredMap scored;
  scored.name = record.robot;
  if (!place_by_truth(trajectory_of(team_map::stop_ends(
                          submaps,
                          {record.T_map_submaps.begin(),
                           record.T_map_submaps.begin() + static_cast<std::ptrdiff_t>(stops)})),
                      truth,
                      scored)) {
    return std::nullopt;
  }
  scored.last_m = record.T_map_submaps[stops - 1].position_m();
  mapping::SonarMapperParams params = team_map::TeamMapParams().mapper;
  params.surfaces.beam_half_angle_rad = record.beam_half_angle_rad;
  team_map::MergedMapper mapper(params);
  for (std::size_t i = 1; i <= stops; ++i) {
    const auto count = static_cast<std::ptrdiff_t>(i);
    const auto placed =
        team_map::placed({submaps.begin(), submaps.begin() + count},
                         {record.T_map_submaps.begin(), record.T_map_submaps.begin() + count});
    const auto merged = mapper.merge({{record.robot, record.body_radius_m, placed}});
    scored.stop_s.push_back(submaps[i - 1].end_s);
    scored.seen.push_back(free_cells(*merged.grid, scored.T_world_map, floor_m));
    scored.middle_m += record.T_map_submaps[i - 1].position_m() / static_cast<double>(stops);
  }
  return scored;
}

FleetCourse score_course(const std::vector<ScoredMap>& maps,
                         const std::vector<MemberReport>& members) {
  FleetCourse course;
  if (members.empty()) {
    return course;
  }
  course.joined_s = joined_s(maps, members);
  for (const MemberReport& member : members) {
    for (const LoggedJoin& join : member.joins) {
      const bool wrong = is_wrong(join, maps);
      course.wrong_joins += wrong ? 1U : 0U;
      course.wrong_joins_left += wrong && !join.until_s ? 1U : 0U;
    }
  }
  for (const double now_s : times_s(maps, members)) {
    course.floor_seen = 0.0;
    for (const MemberReport& member : members) {
      course.floor_seen = std::max(course.floor_seen, member_share(member, maps, now_s));
    }
    if (!course.floor_90_s && course.floor_seen >= kEnoughShare) {
      course.floor_90_s = now_s;
    }
  }
  return course;
}

}  // namespace echomap::apps

// SPDX-License-Identifier: MIT
#include "tests/support/offline_team.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "hil_mock/world/robot_world.hpp"
#include "host/evaluation/floor_seen.hpp"
#include "host/mapping/sonar_mapper.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "host/slam/slam_methods.hpp"
#include "host/team_exploration/peer_echo_filter.hpp"
#include "host/team_exploration/team_explorer.hpp"
#include "tests/support/offline_exploration.hpp"
#include "tests/support/offline_robot.hpp"

namespace echomap::tests {

namespace {

using exploration::Motion;
using exploration::MotionResult;
using geometry::Pose2;
using team_exploration::Claim;
using team_exploration::Peer;
using team_exploration::TeamView;

constexpr std::size_t kManyStops = 500;
constexpr double kWayStepM = 0.1;

/// Values with the times they were published at.
template <class Value>
class History {
 public:
  void add(double now_s, Value value) { values_.emplace_back(now_s, std::move(value)); }
  /// The last before; null where there is none.
  const Value* at(double now_s) const {
    const auto after =
        std::upper_bound(values_.begin(), values_.end(), now_s, [](double time_s, const auto& one) {
          return time_s < one.first;
        });
    return after == values_.begin() ? nullptr : &std::prev(after)->second;
  }
  const Value& last() const { return values_.back().second; }

 private:
  std::vector<std::pair<double, Value>> values_;
};

struct PublishedPose {
  Pose2 T_map_robot;
  double speed_m_per_s = 0.0;
};

class Team;

/// One robot with its world, its map and its view of the team.
class Member final : public team_exploration::TeamBoard {
 public:
  Member(Team& team, std::size_t index, const world::FloorPlan& room, std::uint32_t seed);

  TeamView view() override;
  void claim(const std::optional<Claim>& claim) override { claims.add(now_s(), claim); }

  double now_s() const { return robot ? robot->now_s() : 0.0; }
  bool has_finished() const { return outcome.reason.has_value(); }
  world::Disc disc() const {
    return {world.T_world_robot().position_m(), world.robot().body.radius_m};
  }
  void move_on();
  /// Of the floor in reach, by its map of all.
  double share_seen();
  void describe();

  Team& team;
  std::size_t index;
  std::string name;
  world::RobotWorld world;
  pipeline::RobotPipeline pipeline;
  std::optional<team_exploration::PeerEchoFilter> filter;
  std::optional<OfflineRobot> robot;
  std::optional<team_exploration::TeamExplorer> explorer;
  MotionResult last = MotionResult::kReached;
  History<PublishedPose> poses;
  History<std::optional<Claim>> claims;
  History<std::size_t> scans;  ///< So many in its map.
  OfflineMember outcome;
  bool has_new_scan = false;
  double waiting_since_s = -1.0;
  double longest_wait_s = 0.0;

 private:
  std::vector<Peer> peers(double then_s) const;
  void update_map();

  mapping::SonarMapper mapper_;
  std::vector<std::pair<std::size_t, std::size_t>> in_map_;  ///< Robot and scan, as they came.
  std::shared_ptr<const std::vector<mapping::Scan>> own_scans_;
  TeamView view_;
};

class Team {
 public:
  Team(const world::FloorPlan& room,
       const world::RobotParams& robot,
       const std::vector<Pose2>& starts,
       std::uint32_t seed,
       const OfflineTeamSettings& settings)
      : settings(settings), robot(robot), starts(starts), truth(truth_of(room)) {
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const auto own_seed = static_cast<std::uint32_t>(seed * 10 + i);
      members.emplace_back(*this, i, room.starting_at(starts[i]), own_seed);
    }
  }

  OfflineTeamRun run();

  const OfflineTeamSettings& settings;
  const world::RobotParams& robot;
  const std::vector<Pose2>& starts;
  evaluation::MapTruth truth;
  std::list<Member> members;

 private:
  Member* next();
  void set_peers(Member& member);
  void count_touches(OfflineTeamRun& run);

  std::vector<char> touching_;
};

pipeline::RobotPipeline pipeline_of(const world::RobotParams& robot) {
  return pipeline::RobotPipeline(
      assumed_geometry(robot), mapper_for(robot), {}, slam::slam_by_name("multiscan").make());
}

team_exploration::TeamExplorerParams explorer_params(const world::RobotParams& robot,
                                                     const std::string& name) {
  team_exploration::TeamExplorerParams params;
  const double radius_m = robot.body.radius_m;
  params.frontier.navigator.costs.robot_radius_m = radius_m;
  params.frontier.max_stops = kManyStops;
  params.avoidance.robot = name;
  params.avoidance.navigator = params.frontier.navigator;
  params.avoidance.guard.robot_radius_m = radius_m;
  params.avoidance.aside.costs.robot_radius_m = radius_m;
  return params;
}

Member::Member(Team& all, std::size_t i, const world::FloorPlan& room, std::uint32_t seed)
    : team(all),
      index(i),
      name(1, static_cast<char>('a' + i)),
      world(room, all.robot, seed),
      pipeline(pipeline_of(all.robot)),
      mapper_(mapper_for(all.robot)) {
  const auto geometry = assumed_geometry(all.robot);
  team_exploration::PeerEchoParams echo;
  echo.beam_half_angle_rad = all.robot.sonar.beam_half_angle_rad;
  echo.robot_radius_m = all.robot.body.radius_m;
  filter.emplace(
      pipeline,
      geometry,
      [this] { return pipeline.pose_estimate().T_map_robot; },
      [this](time::RobotTime) { return peers(std::numeric_limits<double>::infinity()); },
      echo);
  robot.emplace(world, geometry, *filter);
  robot->look_around_on_the_way();
  explorer.emplace(*this, explorer_params(all.robot, name));
  poses.add(0.0, {});
  scans.add(0.0, 0);
}

/// As they had published it by then.
std::vector<Peer> Member::peers(double then_s) const {
  std::vector<Peer> peers;
  if (now_s() < team.settings.frames_known_s) {
    return peers;
  }
  for (const Member& other : team.members) {
    const PublishedPose* published = other.poses.at(then_s);
    if (&other == this || published == nullptr) {
      continue;
    }
    const Pose2 T_map_map = team.starts[index].inverse() * team.starts[other.index];
    peers.push_back({other.name,
                     T_map_map * published->T_map_robot,
                     team.settings.position_stddev_m,
                     team.robot.body.radius_m,
                     std::isfinite(then_s) ? now_s() - then_s : 0.0,
                     published->speed_m_per_s});
  }
  return peers;
}

TeamView Member::view() {
  const double known_s = now_s() - team.settings.delay_s;
  if (team.members.size() == 1 || now_s() < team.settings.frames_known_s) {
    return {};
  }
  update_map();
  const double period_s = team.settings.pose_period_s;
  view_.peers = peers(std::max(0.0, period_s * std::floor(known_s / period_s)));
  view_.claims.clear();
  for (const Member& other : team.members) {
    const auto* published = other.claims.at(known_s);
    if (&other != this && published != nullptr && *published) {
      Claim claim = **published;
      claim.at_m = team.starts[index].inverse() * (team.starts[other.index] * claim.at_m);
      view_.claims.push_back(claim);
    }
  }
  return view_;
}

/// From what all have published so far, where their maps have it now.
void Member::update_map() {
  const double known_s = now_s() - team.settings.delay_s;
  bool has_changed = false;
  std::vector<std::size_t> known(team.members.size(), 0);
  for (const auto& [robot_index, scan] : in_map_) {
    known[robot_index] = std::max(known[robot_index], scan + 1);
  }
  std::vector<pipeline::Snapshot> snapshots;
  for (Member& other : team.members) {
    const double then_s = &other == this ? now_s() : known_s;
    const auto* published = other.scans.at(then_s);
    for (std::size_t i = known[other.index]; published != nullptr && i < *published; ++i) {
      in_map_.emplace_back(other.index, i);
      has_changed = true;
    }
  }
  if (!has_changed && view_.grid) {
    return;
  }
  std::vector<Eigen::Vector2d> track_m;
  auto been_m = std::make_shared<std::vector<Eigen::Vector2d>>();
  for (Member& other : team.members) {
    snapshots.push_back(other.pipeline.snapshot());
    const Pose2 T_map_map = team.starts[index].inverse() * team.starts[other.index];
    Eigen::Vector2d last_m(1e9, 0.0);
    for (const auto& pose : *snapshots.back().trajectory) {
      const Eigen::Vector2d at_m = pose.T_map_robot.position_m();
      if ((at_m - last_m).norm() > kWayStepM) {
        last_m = at_m;
        track_m.emplace_back(T_map_map * at_m);
        if (&other != this) {
          been_m->push_back(track_m.back());
        }
      }
    }
  }
  auto all = std::make_shared<std::vector<mapping::Scan>>();
  for (const auto& [robot_index, scan] : in_map_) {
    const Pose2 T_map_map = team.starts[index].inverse() * team.starts[robot_index];
    const auto& scans_there = *snapshots[robot_index].scans;
    if (scan < scans_there.size()) {
      all->push_back(mapping::moved(scans_there[scan], T_map_map));
    }
  }
  mapper_.take(*all, track_m);
  view_.grid = std::make_shared<const mapping::OccupancyGrid>(mapper_.grid());
  view_.features = std::make_shared<const mapping::SonarFeatures>(mapper_.features());
  view_.scans = all;
  view_.been_m = been_m;
}

void Member::move_on() {
  const Motion motion = explorer->next(pipeline.snapshot(), last);
  if (const auto* finished = std::get_if<exploration::Finished>(&motion)) {
    outcome.reason = finished->reason;
    return;
  }
  if (std::holds_alternative<exploration::Stand>(motion)) {
    waiting_since_s = waiting_since_s < 0.0 ? now_s() : waiting_since_s;
    longest_wait_s = std::max(longest_wait_s, now_s() - waiting_since_s);
  } else {
    waiting_since_s = -1.0;
  }
  last = robot->execute(motion);
  const auto* roll = std::get_if<exploration::Roll>(&motion);
  poses.add(now_s(),
            {pipeline.pose_estimate().T_map_robot, roll != nullptr ? roll->forward_m_per_s : 0.0});
  if (std::holds_alternative<exploration::EndScan>(motion)) {
    scans.add(now_s(), pipeline.snapshot().scans->size());
    has_new_scan = true;
  }
}

double Member::share_seen() {
  const TeamView seen = view();
  const auto grid = seen.grid ? seen.grid : pipeline.snapshot().grid;
  const Pose2& T_world_map = team.starts[index];
  return evaluation::floor_seen(mapping::rasterize(*grid),
                                T_world_map,
                                team.truth.cells,
                                T_world_map.position_m(),
                                team.robot.body.radius_m);
}

void Member::describe() {
  outcome.now_s = now_s();
  outcome.stops = pipeline.snapshot().stops;
  outcome.encounters = explorer->encounters();
  outcome.lost_bids = explorer->lost_bids();
  outcome.echoes_of_peers = filter->echoes_of_peers();
}

Member* Team::next() {
  Member* first = nullptr;
  for (Member& member : members) {
    if (!member.has_finished() && (first == nullptr || member.now_s() < first->now_s())) {
      first = &member;
    }
  }
  return first;
}

void Team::set_peers(Member& member) {
  std::vector<world::Disc> others;
  for (const Member& other : members) {
    if (&other != &member) {
      others.push_back(other.disc());
    }
  }
  member.world.set_peers(others);
}

void Team::count_touches(OfflineTeamRun& run) {
  constexpr double kTouchM = 0.008;
  touching_.resize(members.size() * members.size(), 0);
  for (const Member& one : members) {
    for (const Member& other : members) {
      if (one.index >= other.index) {
        continue;
      }
      char& was = touching_[one.index * members.size() + other.index];
      const double apart_m = (one.disc().middle_m - other.disc().middle_m).norm();
      const bool is = apart_m < one.disc().radius_m + other.disc().radius_m + kTouchM;
      run.touches += is && was == 0 ? 1 : 0;
      was = is ? 1 : 0;
    }
  }
}

OfflineTeamRun Team::run() {
  OfflineTeamRun run;
  while (Member* member = next()) {
    if (run.covered_s || member->now_s() > settings.max_s) {
      break;
    }
    set_peers(*member);
    member->move_on();
    count_touches(run);
    if (std::exchange(member->has_new_scan, false)) {
      run.share = std::max(run.share, member->share_seen());
      if (run.share >= settings.enough_share) {
        run.covered_s = member->now_s();
      }
    }
  }
  for (Member& member : members) {
    member.describe();
    run.longest_wait_s = std::max(run.longest_wait_s, member.longest_wait_s);
    run.members.push_back(member.outcome);
  }
  return run;
}

}  // namespace

OfflineTeamRun explore_as_team(const world::FloorPlan& room,
                               const world::RobotParams& robot,
                               const std::vector<Pose2>& starts,
                               std::uint32_t seed,
                               const OfflineTeamSettings& settings) {
  return Team(room, robot, starts, seed, settings).run();
}

}  // namespace echomap::tests

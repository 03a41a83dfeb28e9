// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "host/geometry/angle.hpp"
#include "host/team_map/team_map.hpp"
#include "tests/support/team_recording.hpp"

namespace {

using echomap::geometry::Pose2;
using echomap::tests::TeamRecording;
using Team = std::vector<TeamRecording>;

struct Outcome {
  double joined_s = -1.0;  ///< From here on to the end.
  double error_m = 0.0;
  double own_m = 0.0;
  double heading_error_deg = 0.0;
  double final_error_m = 0.0;
  double final_own_m = 0.0;
  double wrong_s = 0.0;  ///< Joined wrongly for so long.
  bool is_wrong_at_end = false;
  double end_s = 0.0;
  /// Of where the second robot stood last, as seen from where the first one did, in standard
  /// deviations: of the position (two degrees of freedom) and of the heading.
  double position_off = 0.0;
  double heading_off = 0.0;
};

/// How honest the standard deviations of relative poses are: over all updates of all joined pairs,
/// the errors of positions and headings in these deviations.
struct Honesty {
  std::size_t poses = 0;
  std::size_t positions_within_2 = 0;
  std::size_t headings_within_2 = 0;
  double position_squares = 0.0;
  double heading_squares = 0.0;

  void add(const Outcome& outcome) {
    ++poses;
    positions_within_2 += outcome.position_off <= 2.0 ? 1 : 0;
    headings_within_2 += std::abs(outcome.heading_off) <= 2.0 ? 1 : 0;
    position_squares += outcome.position_off * outcome.position_off;
    heading_squares += outcome.heading_off * outcome.heading_off;
  }
};

struct Cost {
  double sum_ms = 0.0;
  double max_ms = 0.0;
  std::size_t updates = 0;
};

bool is_right(const Team& team,
              const echomap::team_map::TeamMap& map,
              std::size_t a,
              std::size_t b,
              const std::vector<std::size_t>& stops,
              Outcome& outcome) {
  const auto relative = map.relative_pose(team[a].record.robot, team[b].record.robot);
  const auto& T_a = team[a].stops[stops[a] - 1].T_map_submaps;
  const auto& T_b = team[b].stops[stops[b] - 1].T_map_submaps;
  outcome.final_own_m =
      team[a].error_m(team[a].T_world_start, T_a) + team[b].error_m(team[b].T_world_start, T_b);
  outcome.final_error_m = team[b].error_m(team[a].T_world_start * relative->T_own_peer, T_b);
  const Pose2 T_true = team[a].T_world_start.inverse() * team[b].T_world_start;
  outcome.heading_error_deg = std::abs(echomap::geometry::degrees(
      echomap::geometry::angle_between(T_true.heading_rad(), relative->T_own_peer.heading_rad())));
  const Pose2 T_stands = T_a.back().inverse() * relative->T_own_peer * T_b.back();
  const Pose2 T_true_stands =
      team[a].T_world_submaps[T_a.size() - 1].inverse() * team[b].T_world_submaps[T_b.size() - 1];
  outcome.position_off =
      (T_stands.position_m() - T_true_stands.position_m()).norm() / relative->position_stddev_m;
  outcome.heading_off =
      echomap::geometry::angle_between(T_true_stands.heading_rad(), T_stands.heading_rad()) /
      relative->heading_stddev_rad;
  return outcome.final_error_m < 0.4 + outcome.final_own_m && outcome.heading_error_deg < 15.0;
}

/// Tells a team map stop after stop what some robots of the team recorded.
std::vector<Outcome> replay(const Team& team,
                            const std::vector<std::size_t>& robots,
                            Cost& cost,
                            Honesty& honesty) {
  echomap::team_map::TeamMap map;
  std::vector<std::pair<double, std::size_t>> events;
  for (const std::size_t robot : robots) {
    for (const auto& stop : team[robot].stops) {
      events.emplace_back(stop.end_s, robot);
    }
  }
  std::sort(events.begin(), events.end());
  std::vector<std::size_t> stops(team.size(), 0);
  std::vector<Outcome> outcomes(robots.size() * robots.size());
  double before_s = 0.0;
  for (const auto& [now_s, robot] : events) {
    map.take(team[robot].after(++stops[robot]));
    const auto begin = std::chrono::steady_clock::now();
    map.update();
    const double ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    cost.sum_ms += ms;
    cost.max_ms = std::max(cost.max_ms, ms);
    ++cost.updates;
    for (std::size_t i = 0; i < robots.size(); ++i) {
      for (std::size_t k = i + 1; k < robots.size(); ++k) {
        Outcome& outcome = outcomes[i * robots.size() + k];
        outcome.end_s = now_s;
        outcome.wrong_s += outcome.is_wrong_at_end ? now_s - before_s : 0.0;
        outcome.is_wrong_at_end = false;
        if (!map.relative_pose(team[robots[i]].record.robot, team[robots[k]].record.robot)) {
          outcome.joined_s = -1.0;
          continue;
        }
        const bool right = is_right(team, map, robots[i], robots[k], stops, outcome);
        outcome.is_wrong_at_end = !right;
        if (right) {
          honesty.add(outcome);
        }
        if (!right) {
          outcome.joined_s = -1.0;
        } else if (outcome.joined_s < 0.0) {
          outcome.joined_s = now_s;
          outcome.error_m = outcome.final_error_m;
          outcome.own_m = outcome.final_own_m;
        }
      }
    }
    before_s = now_s;
  }
  return outcomes;
}

void print(const std::string& world,
           int seed,
           const std::vector<Outcome>& outcomes,
           std::size_t robots,
           const std::vector<std::size_t>& which) {
  for (std::size_t i = 0; i < robots; ++i) {
    for (std::size_t k = i + 1; k < robots; ++k) {
      const Outcome& one = outcomes[i * robots + k];
      std::printf(
          "%s seed %d pair %zu%zu joined_s %5.0f of %5.0f err %.3f own %.3f final %.3f own %.3f "
          "deg "
          "%.1f off %.2f %.2f wrong_s %.0f%s\n",
          world.c_str(),
          seed,
          which[i] + 1,
          which[k] + 1,
          one.joined_s,
          one.end_s,
          one.error_m,
          one.own_m,
          one.final_error_m,
          one.final_own_m,
          one.heading_error_deg,
          one.position_off,
          one.heading_off,
          one.wrong_s,
          one.is_wrong_at_end ? " WRONG AT THE END" : "");
    }
  }
}

}  // namespace

/// join_offline WORLD pairs|team ROBOTS FIRST LAST FOLDER: joins the maps of so many robots of each
/// seed, two at a time or all at once.
int main(int argc, char** argv) {
  if (argc != 7) {
    std::fprintf(stderr, "usage: join_offline WORLD pairs|team ROBOTS FIRST LAST FOLDER\n");
    return 2;
  }
  const std::size_t robots = std::strtoul(argv[3], nullptr, 10);
  std::vector<std::size_t> all(robots);
  std::iota(all.begin(), all.end(), 0);
  Cost cost;
  Honesty honesty;
  for (int seed = std::atoi(argv[4]); seed <= std::atoi(argv[5]); ++seed) {
    const Team team =
        echomap::tests::team_recordings(argv[1], robots, static_cast<std::uint32_t>(seed), argv[6]);
    if (std::string(argv[2]) == "team") {
      print(argv[1], seed, replay(team, all, cost, honesty), robots, all);
    } else {
      for (std::size_t a = 0; a < robots; ++a) {
        for (std::size_t b = a + 1; b < robots; ++b) {
          print(argv[1], seed, replay(team, {a, b}, cost, honesty), 2, {a, b});
        }
      }
    }
    std::fflush(stdout);
  }
  std::printf("%.0f ms an update, at most %.0f\n",
              cost.sum_ms / static_cast<double>(cost.updates),
              cost.max_ms);
  const auto poses = static_cast<double>(std::max<std::size_t>(1, honesty.poses));
  std::printf(
      "%zu poses of joined pairs: within 2 standard deviations %.1f %% of positions, %.1f %% of "
      "headings; root mean square %.2f, %.2f deviations\n",
      honesty.poses,
      100.0 * static_cast<double>(honesty.positions_within_2) / poses,
      100.0 * static_cast<double>(honesty.headings_within_2) / poses,
      std::sqrt(honesty.position_squares / poses),
      std::sqrt(honesty.heading_squares / poses));
}

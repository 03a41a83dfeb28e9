// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstdlib>
#include <string>

#include "host/exploration/explorer.hpp"
#include "tests/support/offline_exploration.hpp"
#include "tests/support/offline_team.hpp"
#include "tests/support/team_recording.hpp"

namespace {

using echomap::tests::OfflineTeamRun;

void print_run(const char* room,
               std::size_t robots,
               std::uint32_t seed,
               const OfflineTeamRun& run) {
  std::printf("%s robots %zu seed %2u  covered %5.0f s  share %.3f  touches %zu  wait %3.0f s ",
              room,
              robots,
              seed,
              run.covered_s.value_or(-1.0),
              run.share,
              run.touches,
              run.longest_wait_s);
  for (const auto& member : run.members) {
    const auto& met = member.encounters;
    std::printf(" | %zu stops, waits %zu bumps %zu locks %zu way %zu no %zu lost %zu echoes %zu %s",
                member.stops,
                met.waits,
                met.bumps,
                met.deadlocks,
                met.made_way,
                met.without_place,
                member.lost_bids,
                member.echoes_of_peers,
                member.reason ? echomap::exploration::name_of(*member.reason) : "");
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

/// team_offline ROOM ROBOTS FIRST LAST [KNOWN_S [SHARE [MAX_S]]]: so many robots explore
/// a room together, for the seeds FIRST .. LAST, until a map has SHARE of the floor. Frames are
/// known from KNOWN_S on. The starts of a seed are those of 4 robots, of which the first take part.
int main(int argc, char** argv) {
  if (argc < 5) {
    std::fprintf(stderr, "usage: team_offline ROOM ROBOTS FIRST LAST [KNOWN_S [SHARE [MAX_S]]]\n");
    return 2;
  }
  constexpr double kApartM = 2.0;
  const auto room = echomap::tests::bundled_room(argv[1]);
  const auto robot = echomap::tests::bundled_robot("uno_2wd");
  const std::size_t robots = std::strtoul(argv[2], nullptr, 10);
  const auto last = static_cast<std::uint32_t>(std::strtoul(argv[4], nullptr, 10));
  echomap::tests::OfflineTeamSettings settings;
  settings.frames_known_s = argc > 5 ? std::strtod(argv[5], nullptr) : 0.0;
  settings.enough_share = argc > 6 ? std::strtod(argv[6], nullptr) : settings.enough_share;
  settings.max_s = argc > 7 ? std::strtod(argv[7], nullptr) : settings.max_s;
  for (auto seed = static_cast<std::uint32_t>(std::strtoul(argv[3], nullptr, 10)); seed <= last;
       ++seed) {
    auto starts = echomap::tests::team_starts(room, 4, kApartM, seed);
    starts.resize(robots);
    print_run(argv[1],
              robots,
              seed,
              echomap::tests::explore_as_team(room, robot, starts, seed, settings));
  }
}

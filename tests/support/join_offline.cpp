// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstdlib>

#include "tests/support/team_recording.hpp"

/// join_offline WORLD ROBOTS FIRST LAST FOLDER
int main(int argc, char** argv) {
  if (argc != 6) {
    std::fprintf(stderr, "usage: join_offline WORLD ROBOTS FIRST LAST FOLDER\n");
    return 2;
  }
  for (int seed = std::atoi(argv[3]); seed <= std::atoi(argv[4]); ++seed) {
    const auto team = echomap::tests::team_recordings(argv[1],
                                                      static_cast<std::size_t>(std::atoi(argv[2])),
                                                      static_cast<std::uint32_t>(seed),
                                                      argv[5]);
    for (const auto& one : team) {
      double sum = 0.0;
      for (std::size_t i = 0; i < one.T_world_submaps.size(); ++i) {
        const auto est = one.T_world_start * one.record.T_map_submaps[i];
        sum += (est.position_m() - one.T_world_submaps[i].position_m()).squaredNorm();
      }
      std::printf("seed %3d %s stops %zu end %.0f s ate %.3f m\n",
                  seed,
                  one.record.robot.c_str(),
                  one.stops.size(),
                  one.stops.back().end_s,
                  std::sqrt(sum / static_cast<double>(one.stops.size())));
      std::fflush(stdout);
    }
  }
}

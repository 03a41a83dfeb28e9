// SPDX-License-Identifier: MIT
#include "tests/sessions/hijacks.hpp"

#include <random>

#include "host/robot_link/robot_probe.hpp"
#include "tests/hil/emulated_board.hpp"
#include "tests/sessions/simulated_session.hpp"

namespace echomap::tests {

Hijacks measure_hijacks(const std::filesystem::path& elf, int tries, std::uint32_t seed) {
  const auto chip = make_emulated_board(elf);
  SimulatedSession sim(chip->pins(), "empty_room", seed);
  std::mt19937 random(seed);
  double at_s = 0.0;
  bool is_said = true;
  sim.each_step = [&] {
    if (!is_said && sim.now_s() >= at_s) {
      sim.intrude(robot_link::RobotProbe(static_cast<std::uint16_t>(random())).hello());
      is_said = true;
    }
  };
  sim.session().connect();
  Hijacks result;
  for (; result.tries < tries; ++result.tries) {
    at_s = sim.now_s() + 0.05 + double(random() % 500) * 1e-3;
    is_said = false;
    const double distance_m = result.tries % 2 == 0 ? 0.2 : -0.2;
    const auto end = sim.session().execute(exploration::Drive{distance_m});
    const auto& statistics = sim.session().link().statistics();
    const bool is_kept = end == exploration::MotionResult::kReached && is_said &&
                         statistics.outages == 0 && statistics.resets_seen == 0;
    result.refused += is_kept ? 1 : 0;
  }
  return result;
}

}  // namespace echomap::tests

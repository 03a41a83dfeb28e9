// SPDX-License-Identifier: MIT
#include "tests/firmware/differential/program.hpp"

#include "firmware/app/robot.hpp"
#include "firmware/hal/events.hpp"
#include "tests/firmware/differential/random_host.hpp"
#include "tests/firmware/differential/world.hpp"

namespace echomap {
namespace differential {

World world(0);

void run(const Request& request) {
  world = World(request.seed);
  RandomHost host(world.random());
  app::robot.start();
  uint32_t until_report = request.report_every;
  for (uint32_t step = 1; step <= request.steps; ++step) {
    if (host.step()) {
      world.change();
    }
    world.step();
    hal::on_tick();
    while (app::robot.run_once()) {
    }
    world.drain();
    if (--until_report == 0) {
      until_report = request.report_every;
      if (step >= request.report_from) {
        report(Report{step, world.trace().sum, world.trace().sum_of_sums});
      }
    }
  }
}

}  // namespace differential
}  // namespace echomap

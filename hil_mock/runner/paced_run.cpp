// SPDX-License-Identifier: MIT
#include "hil_mock/runner/paced_run.hpp"

#include <algorithm>
#include <chrono>

#include "hil_mock/runner/stop_signal.hpp"
#include "hil_mock/runner/wait_readable.hpp"

namespace echomap::runner {
namespace {

/// Most simulated time between two looks at the byte stream.
constexpr std::int64_t kSliceNs = 2'000'000;
constexpr std::chrono::microseconds kRest{1000};

}  // namespace

void run_paced(RobotSimulation& simulation,
               ByteEndpoint& endpoint,
               Pacer pacer,
               std::int64_t end_ns) {
  while (!stop_requested() && simulation.now_ns() < end_ns) {
    if (const auto bytes = endpoint.receive(); !bytes.empty()) {
      simulation.receive(bytes);
    }
    const std::int64_t now_ns = simulation.now_ns();
    const std::int64_t due_ns =
        std::min(end_ns, pacer.due_ns(std::chrono::steady_clock::now(), now_ns));
    simulation.advance_to(std::min(due_ns, now_ns + kSliceNs));
    endpoint.send(simulation.take_sent());
    if (due_ns <= simulation.now_ns()) {
      wait_readable(endpoint, -1, kRest);
    }
  }
}

}  // namespace echomap::runner

// SPDX-License-Identifier: MIT
#include <string>
#include <variant>

#include "hil_mock/runner/lockstep_server.hpp"
#include "host/transport/lockstep_lines.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace {

using echomap::fuzz::require;
namespace runner = echomap::runner;
namespace transport = echomap::transport;

void check_request(const std::string& line) {
  const runner::LockstepRequest request = runner::parse_request(line);
  if (const auto* grant = std::get_if<runner::Grant>(&request)) {
    const std::string again =
        "grant " + std::to_string(grant->until_us) + " " + std::to_string(grant->host_bytes);
    require(runner::parse_request(again) == request, "a grant written again is the same");
  }
  const auto* bad = std::get_if<runner::BadRequest>(&request);
  require(bad == nullptr || bad->line == line, "a bad line is told as it came");
}

void check_reached(const std::string& line) {
  const auto reached = transport::parse_reached(line);
  if (!reached) {
    return;
  }
  require(reached->true_pose || line.find('-', line.rfind(' ')) == std::string::npos,
          "no count of bytes is negative");
  const auto again = transport::parse_reached("reached " + std::to_string(reached->until_us) + " " +
                                              std::to_string(reached->device_bytes));
  require(
      again && again->until_us == reached->until_us && again->device_bytes == reached->device_bytes,
      "an answer written again is the same");
}

}  // namespace

std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  return {input_of("grant 20000 117"),
          input_of("quit"),
          input_of("box 1500 -250 300"),
          input_of("cut-cable 3000000"),
          input_of("tell-truth"),
          input_of("reached 20000 4096"),
          input_of("reached 20000 4096 1500000 -250000 90000000"),
          input_of("bye"),
          input_of(R"({"lockstep":1,"firmware":"echomap-uno 0.1.0","emulator":"simavr 1.6"})")};
}

/// One input is a line of either side of the lockstep channel.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string line = echomap::fuzz::text_of({data, size});
  check_request(line);
  check_reached(line);
  transport::parse_lockstep_hello(line);
  return 0;
}

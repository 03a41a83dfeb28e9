// SPDX-License-Identifier: MIT
#include <algorithm>

#include "host/robot_link/robot_probe.hpp"
#include "tests/fuzz/frames.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace {

using echomap::fuzz::require;

bool is_printable(char character) {
  return character == '\n' || (character >= ' ' && character < '\x7F');
}

}  // namespace

std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  std::vector<Input> seeds = golden_frames();
  seeds.push_back(input_of("ERROR\r\n\x1B[2J"));
  return seeds;
}

/// One input is what some device at a port says.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  echomap::robot_link::RobotProbe probe(0x1267);
  probe.receive({data, size});
  const std::string preview = probe.preview().text();
  require(std::all_of(preview.begin(), preview.end(), is_printable),
          "a preview does nothing to a terminal");
  require(std::count(preview.begin(), preview.end(), '\n') <= 4, "a preview has four lines");
  return 0;
}

// SPDX-License-Identifier: MIT
#include <random>

#include "tests/fuzz/fuzz_target.hpp"

// What stands for libFuzzer in every build that has none: each seed, and each of them damaged in
// some random ways, the same ones every time.
namespace {

using echomap::fuzz::Input;

constexpr int kDamagedInputs = 2000;

/// One byte changed, lost or doubled.
void damage(Input& input, std::mt19937& random) {
  if (input.empty()) {
    return;
  }
  const auto at = input.begin() + static_cast<std::ptrdiff_t>(random() % input.size());
  switch (random() % 4) {
    case 0:
      *at = static_cast<std::uint8_t>(random());
      break;
    case 1:
      *at ^= static_cast<std::uint8_t>(1U << (random() % 8));
      break;
    case 2:
      input.erase(at);
      break;
    default:
      input.insert(at, *at);
  }
}

void run(const Input& input) { LLVMFuzzerTestOneInput(input.data(), input.size()); }

}  // namespace

int main() {
  const std::vector<Input> seeds = echomap::fuzz::seeds();
  echomap::fuzz::require(!seeds.empty(), "there are seeds");
  for (const Input& seed : seeds) {
    run(seed);
  }
  std::mt19937 random(1);
  for (int i = 0; i < kDamagedInputs; ++i) {
    Input input = seeds[random() % seeds.size()];
    for (auto faults = 1 + random() % 4; faults > 0; --faults) {
      damage(input, random);
    }
    run(input);
  }
  return EXIT_SUCCESS;
}

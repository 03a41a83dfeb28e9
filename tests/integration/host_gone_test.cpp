// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kCyclesPerMs = 16'000;
/// Time to live, braking from the fastest speed, and a control period.
constexpr std::int64_t kLongestStop = (200 + 128 + 4) * kCyclesPerMs;

/// Kills the host right after its first stop, when the robot turns or drives; answers the AVR
/// cycles until the wheels stopped, 0 where they stood.
std::int64_t cycles_to_stop(int seed) {
  const tests::ScratchFolder scratch;
  const auto path = [&](const char* name) { return (scratch / name).string(); };
  const std::string seed_option = "--seed=" + std::to_string(seed);
  Program robot("echomap-simavr",
                {"--link=" + path("robot"),
                 "--lockstep=" + path("lockstep"),
                 "--truth=" + path("truth"),
                 seed_option},
                scratch / "robot.log");
  EXPECT_TRUE(eventually([&] { return fs::exists(path("lockstep")); }));
  Program host("echomap",
               {"explore",
                "--port=" + path("robot"),
                "--lockstep=" + path("lockstep"),
                "--out=" + path("run"),
                seed_option},
               scratch / "host.log");
  EXPECT_TRUE(eventually([&] { return fs::exists(path("run/summary.json")); }));
  host.send(SIGKILL);
  host.wait();
  const Ended ended = robot.wait();
  EXPECT_EQ(ended.status, 0) << ended.said;
  const auto truth = nlohmann::json::parse(files::read_text_file(scratch / "truth/truth.json"));
  return truth.at("stop").at("stopped_after_cycles");
}

TEST(HostGone, WheelsStopWithinTheTimeToLiveAndBraking) {
  if (!fs::exists(ECHOMAP_BINARY_DIR "/bin/echomap-simavr")) {
    GTEST_SKIP() << "echomap-simavr was not built on this machine";
  }
  int moving = 0;
  for (int seed = 1; seed <= 12 && moving < 2; ++seed) {
    const std::int64_t cycles = cycles_to_stop(seed);
    EXPECT_LE(cycles, kLongestStop) << "seed " << seed;
    moving += cycles > 0 ? 1 : 0;
    std::printf(
        "seed %d: wheels at zero after %lld AVR cycles\n", seed, static_cast<long long>(cycles));
  }
  EXPECT_EQ(moving, 2) << "the host was never killed in mid-move";
}

}  // namespace
}  // namespace echomap::test

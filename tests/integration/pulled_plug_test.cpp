// SPDX-License-Identifier: MIT
/// An exploration over the USB cable of a Pico that runs its release image, whose plug is pulled.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using tests::kMs;

class PulledPlug : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(ECHOMAP_BINARY_DIR "/bin/echomap-rp2040")) {
      GTEST_SKIP() << "echomap-rp2040 was not built on this machine";
    }
  }

  /// In lockstep, while the plug is out as `away` says.
  Ended explore(const std::string& away, const std::string& stops) {
    const auto socket = scratch / "lockstep";
    const auto port = scratch / "robot";
    const std::vector<std::string> both{"--seed=1", "--lockstep=" + socket.string()};
    std::vector<std::string> of_robot{"--world=nxt_room",
                                      "--faults=away=" + away,
                                      "--link=" + port.string(),
                                      "--truth=" + (scratch / "truth").string()};
    of_robot.insert(of_robot.end(), both.begin(), both.end());
    Program robot("echomap-rp2040", of_robot, scratch / "robot_log");
    EXPECT_TRUE(eventually([&] { return exists(socket) && exists(port); }));
    std::vector<std::string> of_host{"explore",
                                     "--headless",
                                     "--strategy=nxt-farthest",
                                     "--stops=" + stops,
                                     "--port=" + port.string(),
                                     "--out=" + (scratch / "run").string()};
    of_host.insert(of_host.end(), both.begin(), both.end());
    const Ended ended = Program("echomap", of_host, scratch / "log").wait();
    EXPECT_EQ(robot.wait().status, 0);
    return ended;
  }

  nlohmann::json json_in(const char* name) const {
    return nlohmann::json::parse(files::read_text_file(scratch / name));
  }

  const tests::ScratchFolder scratch;
};

TEST_F(PulledPlug, WhileItTurnsAndForGoodStopsTheMotorsAndEndsTheRun) {
  constexpr std::int64_t kPulledNs = 7'400 * kMs;
  /// Time to live, braking, a control period and a step of the world.
  constexpr std::int64_t kLongestStopNs = (200 + 128 + 4 + 1) * kMs;
  const Ended ended = explore("7.4:1000", "2");
  EXPECT_EQ(ended.status, 5);
  EXPECT_THAT(ended.said,
              AllOf(HasSubstr("the map so far is saved: lost "),
                    HasSubstr("the robot stopped sending"),
                    HasSubstr("next: check its cable and its supply")));
  EXPECT_EQ(json_in("run/summary.json").at("outcome"), "link-lost");
  const nlohmann::json truth = json_in("truth/truth.json");
  const auto driven_ns = truth.at("last_driven_ns").get<std::int64_t>() - kPulledNs;
  EXPECT_GT(driven_ns, 0) << "it turned when the plug was pulled";
  EXPECT_LE(driven_ns, kLongestStopNs);
  EXPECT_GT(truth.at("sim_seconds"), 10.0) << "and stood from then on";
}

TEST_F(PulledPlug, InAStopAndPutInAgainIsWaitedFor) {
  const Ended ended = explore("3:2", "1");
  EXPECT_EQ(ended.status, kUnfinished) << ended.said;
  EXPECT_THAT(ended.said, AllOf(HasSubstr("is disconnected: "), HasSubstr("reconnected after ")));
  const nlohmann::json summary = json_in("run/summary.json");
  EXPECT_EQ(summary.at("outcome"), "stop-limit");
  EXPECT_EQ(summary.at("link").at("outages"), 1);
  EXPECT_EQ(summary.at("link").at("resets"), 0);
}

}  // namespace
}  // namespace echomap::test

// SPDX-License-Identifier: MIT
/// `echomap localize` of robots without a sonar, and by the presets of the papers.
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/exports/pgm_yaml.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

using exports::read_trajectory_tum;
using files::read_text_file;
using geometry::Pose2;
using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

class LocalizeWithoutSonar : public ::testing::Test {
 protected:
  std::string at(const std::string& name) const { return (scratch / name).string(); }

  Ended echomap(std::vector<std::string> arguments) const {
    arguments.emplace_back("--headless");
    return Program("echomap", arguments, scratch / "log").wait();
  }
  void demo(const std::string& out, const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"demo", "--emulator=mock", "--out=" + at(out)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = echomap(arguments);
    ASSERT_TRUE(ended.status == 0 || ended.status == 8) << ended.said;
  }
  /// Of a robot at a port, which the test has put down somewhere.
  Ended localize_live(const std::vector<std::string>& robot,
                      const std::vector<std::string>& localize) const {
    std::vector<std::string> mock{
        "--link=" + at("robot"), "--lockstep=" + at("lockstep"), "--truth=" + at("truth")};
    mock.insert(mock.end(), robot.begin(), robot.end());
    Program simulated("echomap-mock", mock, scratch / "robot.log");
    EXPECT_TRUE(eventually([&] { return fs::exists(at("robot")) && fs::exists(at("lockstep")); }));
    std::vector<std::string> arguments{"localize",
                                       "--port=" + at("robot"),
                                       "--lockstep=" + at("lockstep"),
                                       "--out=" + at("found")};
    arguments.insert(arguments.end(), localize.begin(), localize.end());
    Ended ended = echomap(arguments);
    simulated.wait();
    return ended;
  }
  nlohmann::json summary() const {
    return nlohmann::json::parse(read_text_file(scratch / "found/summary.json"));
  }
  /// How far the pose at the end of the run is off, metres, where `map` began at the start of its
  /// robot and `truth` belongs to the robot that was localized.
  double error_m(const std::string& map, const fs::path& truth) const {
    const Pose2 T_world_map =
        read_trajectory_tum(scratch / map / "truth/truth.tum").front().T_map_robot;
    const auto found = read_trajectory_tum(scratch / "found/trajectory.tum").back();
    for (const auto& pose : read_trajectory_tum(truth)) {
      if (pose.stamp >= found.stamp) {
        return ((T_world_map * found.T_map_robot).position_m() - pose.T_map_robot.position_m())
            .norm();
      }
    }
    return std::nan("");
  }

  tests::ScratchFolder scratch;
};

TEST_F(LocalizeWithoutSonar, FindsACreateInTheOutlineThatItHasFollowed) {
  demo("arena",
       {"--robot=create", "--world=create_l", "--strategy=coastal", "--no-kidnap", "--seed=1"});
  const Ended ended =
      localize_live({"--robot=create", "--world=create_l", "--start=0.4,1.8,200", "--seed=5"},
                    {"--robot=create", "--map=" + at("arena")});
  ASSERT_EQ(ended.status, 0) << ended.said;
  EXPECT_EQ(summary().at("status"), "localized");
  EXPECT_LT(error_m("arena", scratch / "truth/truth.tum"), 0.15);
  const Ended again =
      echomap({"localize", at("found"), "--map=" + at("arena"), "--out=" + at("again")});
  EXPECT_EQ(again.status, 0) << "its recording: " << again.said;
  const Ended by_paper = echomap({"localize",
                                  at("found"),
                                  "--map=" + at("arena"),
                                  "--preset=create",
                                  "--out=" + at("by_paper")});
  EXPECT_EQ(by_paper.status, 8) << by_paper.said;
}

TEST_F(LocalizeWithoutSonar, FindsAnEpuckInItsOwnMapOfTheField) {
  demo("field",
       {"--robot=epuck",
        "--world=epuck_field",
        "--strategy=epuck",
        "--camera-params=noise=0.001,heading=0.6",
        "--fixes=udp:127.0.0.1:" + free_port(),
        "--seed=1"});
  const Ended ended =
      echomap({"localize", at("field"), "--map=" + at("field"), "--out=" + at("found")});
  ASSERT_EQ(ended.status, 0) << ended.said;
  EXPECT_LT(error_m("field", scratch / "field/truth/truth.tum"), 0.03);
  const Ended fine = echomap(
      {"replay", at("field"), "--resolution=0.001", "--force", "--out=" + at("millimetres")});
  ASSERT_EQ(fine.status, 0) << fine.said;
  EXPECT_EQ(exports::read_pgm_yaml(scratch / "millimetres/map.yaml").resolution_m(), 0.001);
  const Ended by_paper = echomap({"localize",
                                  at("field"),
                                  "--map=" + at("field"),
                                  "--preset=epuck",
                                  "--resampling=1",
                                  "--out=" + at("by_paper")});
  EXPECT_EQ(by_paper.status, 8) << by_paper.said;
}

TEST_F(LocalizeWithoutSonar, ReadsEightBearingsInThePapersRoundsAndDoesNotClaimThem) {
  demo("map",
       {"--robot=nxt_tribot",
        "--world=nxt_room",
        "--strategy=nxt-farthest",
        "--no-kidnap",
        "--seed=1"});
  const Ended ended =
      localize_live({"--robot=nxt_tribot", "--world=nxt_room", "--start=1.9,1.2,100", "--seed=5"},
                    {"--robot=nxt_tribot", "--map=" + at("map"), "--preset=nxt"});
  EXPECT_EQ(ended.status, 8);
  EXPECT_THAT(ended.said,
              AllOf(HasSubstr("cannot tell whether they are right"), HasSubstr("leave --preset")));
  EXPECT_EQ(summary().at("stops").size(), 10U);
  EXPECT_EQ(summary().at("finished"), false);
}

}  // namespace
}  // namespace echomap::test

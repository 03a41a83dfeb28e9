// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/exports/run_directory.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/log_files.hpp"
#include "tests/support/real_data.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/told_snapshot.hpp"

// Hennessey et al., section III.A: the cone of a sonar and its noise, from its own sweeps.
namespace echomap::test {
namespace {

using files::read_text_file;
using ::testing::AllOf;
using ::testing::HasSubstr;

class Characterise : public ::testing::Test {
 protected:
  Ended echomap(std::vector<std::string> arguments) {
    return Program("echomap", std::move(arguments), scratch / "log").wait();
  }
  nlohmann::json report() const {
    return nlohmann::json::parse(read_text_file(scratch / "report.json"));
  }
  std::string at(const std::string& name) const { return (scratch / name).string(); }

  tests::ScratchFolder scratch;
};

TEST_F(Characterise, FindsTheConeAndTheNoiseOfASonarInASquareRoom) {
  const Ended run = echomap({"demo",
                             "--emulator=mock",
                             "--robot=ev3_mega",
                             "--world=square_room",
                             "--stops=6",
                             "--seed=2",
                             "--no-kidnap",
                             "--headless",
                             "--out=" + at("run")});
  ASSERT_EQ(run.status, 0) << run.said;
  const Ended ended = echomap({"characterise", at("run"), "--json=" + at("report.json")});
  ASSERT_EQ(ended.status, 0) << ended.said;
  EXPECT_THAT(ended.said, HasSubstr("beam_half_angle_deg = "));
  const auto found = report();
  EXPECT_GE(found.at("walls"), 5);
  // hil_mock/robots/ev3_mega.toml: 32.8 degrees, 1 cm.
  EXPECT_NEAR(found.at("beam_width_deg").get<double>(), 32.8, 4.0);
  EXPECT_NEAR(found.at("suggested_beam_half_angle_deg").get<double>(), 16.4, 2.0);
  EXPECT_LE(found.at("beam_width_low_deg"), found.at("beam_width_deg"));
  EXPECT_GE(found.at("beam_width_high_deg"), found.at("beam_width_deg"));
  const auto& noise = found.at("range_noise");
  ASSERT_GE(noise.size(), 4U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(noise[i].at("stddev_m").get<double>(), 0.010, 0.004) << i;
    EXPECT_NEAR(noise[i].at("bias_m").get<double>(), 0.0, 0.006) << i;
  }
}

TEST_F(Characterise, OfTheNxtsScansIsThatOfTheSameWallsByHand) {
  const auto folder = tests::real_data("nxt_sonar_imperial");
  ECHOMAP_SKIP_WITHOUT(folder);
  std::vector<std::string> arguments{
      "characterise", "--format=nxt", "--range-stddev=0.005", "--json=" + at("report.json")};
  for (const char* set : {"train", "test"}) {
    for (int place = 0; place < 5; ++place) {
      arguments.push_back(
          folder / ("place_" + std::string(set) + "_loc_0" + std::to_string(place) + ".dat"));
    }
  }
  const Ended ended = echomap(arguments);
  ASSERT_EQ(ended.status, 0) << ended.said;
  EXPECT_EQ(report().at("walls"), 26);
  EXPECT_NEAR(report().at("beam_width_deg").get<double>(), 28.1, 0.1);
}

TEST_F(Characterise, SaysWhatARecordingLacks) {
  exports::write_run_directory(scratch / "empty", tests::snapshot_of(mapping::OccupancyGrid()), {});
  const Ended nothing = echomap({"characterise", at("empty")});
  EXPECT_EQ(nothing.status, 1);
  EXPECT_THAT(nothing.said, AllOf(HasSubstr("no sweep of a sonar"), HasSubstr("next: ")));

  files::write_text_file(scratch / "scan.dat", "100\n100\n101\n100\n99\n100\n101\n100\n");
  const Ended no_walls = echomap({"characterise", at("scan.dat"), "--format=nxt"});
  EXPECT_EQ(no_walls.status, 1);
  EXPECT_THAT(no_walls.said, HasSubstr("straight walls, but a beam width takes 3"));

  const Ended laser = echomap({"characterise", ECHOMAP_SOURCE_DIR "/tests/data/small_room.clf"});
  EXPECT_EQ(laser.status, 1);
  EXPECT_THAT(laser.said, HasSubstr("laser"));

  EXPECT_EQ(echomap({"characterise"}).status, 2);
  EXPECT_EQ(echomap({"characterise", at("nowhere")}).status, 2);
}

}  // namespace
}  // namespace echomap::test

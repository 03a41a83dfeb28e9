// SPDX-License-Identifier: MIT
#include "host/exports/summary_json.hpp"

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

TEST(SummaryJson, HasNoNumberForEncoderErrorsThatTheBoardCannotSee) {
  RunSummary summary;
  EXPECT_EQ(nlohmann::json::parse(to_json_text(summary)).at("link").at("robot_encoder_errors"), 0);
  summary.link.robot_encoder_errors = std::nullopt;
  summary.link.robot_right_encoder_errors = std::nullopt;
  const auto link = nlohmann::json::parse(to_json_text(summary)).at("link");
  EXPECT_TRUE(link.at("robot_encoder_errors").is_null());
  EXPECT_EQ(link.at("robot_left_encoder_errors"), 0);
  EXPECT_TRUE(link.at("robot_right_encoder_errors").is_null());
}

TEST(SummaryJson, HoldsEveryField) {
  RunSummary summary;
  summary.strategy = "nxt-farthest";
  summary.outcome = "no-new-ground";
  summary.seed = 4294967295U;
  summary.sim_seconds = 123.25;
  summary.stops = 7;
  summary.resumed_stops = 3;
  summary.previous_maps = 2;
  summary.maps_joined = 1;
  summary.clock_rate_error_ppm = -412.5;
  summary.expected_wall_rmse_m = 0.25;
  summary.link.frames_lost = 4;
  summary.link.robot_encoder_errors = 70'000;
  summary.link.robot_left_encoder_errors = 69'999;
  const auto json = nlohmann::json::parse(to_json_text(summary));
  EXPECT_EQ(json.at("strategy"), "nxt-farthest");
  EXPECT_EQ(json.at("outcome"), "no-new-ground");
  EXPECT_EQ(json.at("seed"), 4294967295U);
  EXPECT_EQ(json.at("sim_seconds"), 123.25);
  EXPECT_EQ(json.at("stops"), 7);
  EXPECT_EQ(json.at("resumed_stops"), 3);
  EXPECT_EQ(json.at("previous_maps"), 2);
  EXPECT_EQ(json.at("maps_joined"), 1);
  EXPECT_EQ(json.at("clock_rate_error_ppm"), -412.5);
  EXPECT_EQ(json.at("expected_wall_rmse_m"), 0.25);
  EXPECT_TRUE(json.at("wall_rmse_p90_m").is_null());
  EXPECT_TRUE(json.at("clock_uncertainty_us").is_null());
  EXPECT_TRUE(json.at("pose_stddev_m").is_null());
  EXPECT_TRUE(json.at("pose_stddev_deg").is_null());
  EXPECT_EQ(json.at("link").at("frames_lost"), 4);
  EXPECT_EQ(json.at("link").at("robot_encoder_errors"), 70'000);
  EXPECT_EQ(json.at("link").at("robot_left_encoder_errors"), 69'999);
  EXPECT_EQ(json.at("link").at("robot_right_encoder_errors"), 0);
  EXPECT_TRUE(json.at("link").at("round_trip_us").is_null());
  EXPECT_TRUE(json.at("link").at("robot_stack_free_bytes").is_null());
  for (const char* key : {"frames_received",
                          "frames_bad",
                          "frames_sent",
                          "commands_resent",
                          "credit_released_bytes",
                          "resets",
                          "outages",
                          "outage_seconds",
                          "reconnects",
                          "robot_frames_bad",
                          "robot_frames_lost",
                          "robot_receive_overruns",
                          "robot_telemetry_dropped",
                          "robot_rate_step"}) {
    EXPECT_TRUE(json.at("link").contains(key)) << key;
  }
  for (const char* key : {"echomap_version",
                          "robot",
                          "slam",
                          "outline_by_strategy",
                          "world",
                          "firmware",
                          "emulator",
                          "wall_seconds",
                          "poses",
                          "points",
                          "travelled_m",
                          "free_area_m2"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
}

TEST(SummaryJson, HasTheFaultOfTheRobotOrNull) {
  EXPECT_TRUE(to_json(std::optional<FaultSummary>()).is_null());
  RunSummary summary;
  EXPECT_TRUE(nlohmann::json::parse(to_json_text(summary)).at("robot_fault").is_null());
  summary.robot_fault = {"pan-offset", 0.12, 9.5, 3};
  const auto fault = nlohmann::json::parse(to_json_text(summary)).at("robot_fault");
  EXPECT_EQ(fault, to_json(summary.robot_fault));
  EXPECT_EQ(fault.at("name"), "pan-offset");
  EXPECT_EQ(fault.at("value"), 0.12);
  EXPECT_EQ(fault.at("log_odds"), 9.5);
  EXPECT_EQ(fault.at("stops"), 3);
  summary.robot_fault->log_odds = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(to_json(summary.robot_fault).at("log_odds").is_null());
}

TEST(SummaryJson, StandsBytesThatAreNoText) {
  RunSummary summary;
  summary.firmware = "\xff\xfe \"quoted\"\n";
  EXPECT_TRUE(nlohmann::json::accept(to_json_text(summary)));
}

TEST(SummaryJson, IsAFileWithALineEnd) {
  const tests::ScratchFolder folder;
  write_summary_json(folder / "summary.json", {});
  EXPECT_EQ(files::read_text_file(folder / "summary.json"), to_json_text({}));
  EXPECT_EQ(to_json_text({}).back(), '\n');
}

}  // namespace
}  // namespace echomap::exports

// SPDX-License-Identifier: MIT
#include "host/exports/summary_json.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

TEST(SummaryJson, HoldsEveryField) {
  RunSummary summary;
  summary.strategy = "nxt-farthest";
  summary.outcome = "no-new-ground";
  summary.seed = 4294967295U;
  summary.sim_seconds = 123.25;
  summary.stops = 7;
  summary.clock_rate_error_ppm = -412.5;
  const auto json = nlohmann::json::parse(to_json_text(summary));
  EXPECT_EQ(json.at("strategy"), "nxt-farthest");
  EXPECT_EQ(json.at("outcome"), "no-new-ground");
  EXPECT_EQ(json.at("seed"), 4294967295U);
  EXPECT_EQ(json.at("sim_seconds"), 123.25);
  EXPECT_EQ(json.at("stops"), 7);
  EXPECT_EQ(json.at("clock_rate_error_ppm"), -412.5);
  EXPECT_TRUE(json.at("clock_uncertainty_us").is_null());
  for (const char* key : {"echomap_version",
                          "robot",
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

TEST(SummaryJson, StandsBytesThatAreNoText) {
  RunSummary summary;
  summary.firmware = "\xff\xfe \"quoted\"\n";
  EXPECT_NO_THROW(nlohmann::json::parse(to_json_text(summary)));
}

TEST(SummaryJson, IsAFileWithALineEnd) {
  const tests::ScratchFolder folder;
  write_summary_json(folder / "summary.json", {});
  EXPECT_EQ(files::read_text_file(folder / "summary.json"), to_json_text({}));
  EXPECT_EQ(to_json_text({}).back(), '\n');
}

}  // namespace
}  // namespace echomap::exports

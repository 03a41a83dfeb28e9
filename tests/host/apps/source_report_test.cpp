// SPDX-License-Identifier: MIT
#include "host/apps/source_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "host/mapping/raster_map.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::apps {
namespace {

using console::ExitCode;
using testing::HasSubstr;
using Report = nlohmann::ordered_json;

const NextCommands kAfterSearch{
    "echomap serve found", "echomap search", "echomap localize --map found", "echomap search"};

Report report_of(const std::string& verdict) {
  return {{"verdict", verdict},
          {"none_probability", verdict == "none" ? 0.97 : 0.02},
          {"unseen_probability", 0.01},
          {"min_strength", 1.0},
          {"best_m", {2.0, 1.0}},
          {"found_radius_m", 0.2},
          {"within_probability", 0.96},
          {"radius_95_m", 0.18},
          {"strength", {{"median", 19.5}, {"log_stddev", 0.1}}}};
}

RunEnding drive_of(const std::string& outcome, ExitCode code) {
  return {outcome, code, "the map has 60 % of the floor", "echomap explore"};
}

TEST(SourceReport, OfAFoundSourceIsFinishedThoughTheMapIsNot) {
  const RunEnding ending = ending_of_search(
      drive_of("complete", ExitCode::kUnfinished), report_of("found"), kAfterSearch);
  EXPECT_EQ(ending.code, ExitCode::kOk);
  EXPECT_EQ(ending.outcome, "found");
  EXPECT_THAT(ending.why, HasSubstr("19.5 pulses/s at 1 m"));
  EXPECT_THAT(ending.why, HasSubstr("(2.00, 1.00)"));
  EXPECT_EQ(ending.next, kAfterSearch.use);
}

TEST(SourceReport, OfNoSourceIsFinished) {
  const RunEnding ending =
      ending_of_search(drive_of("complete", ExitCode::kOk), report_of("none"), kAfterSearch);
  EXPECT_EQ(ending.code, ExitCode::kOk);
  EXPECT_THAT(ending.why, HasSubstr("no source of 1.0 pulses/s"));
  EXPECT_THAT(ending.why, HasSubstr("97 %"));
}

TEST(SourceReport, OfNothingSureIsUnfinishedThoughTheMapIsFinished) {
  const RunEnding ending =
      ending_of_search(drive_of("stop-limit", ExitCode::kOk), report_of("unsure"), kAfterSearch);
  EXPECT_EQ(ending.code, ExitCode::kUnfinished);
  EXPECT_THAT(ending.why, HasSubstr("its time is over"));
  EXPECT_EQ(ending.next, kAfterSearch.go_on);
}

TEST(SourceReport, LeavesWhatIsWrongWithTheRobot) {
  const RunEnding ending =
      ending_of_search(drive_of("lifted", ExitCode::kSafetyStop), report_of("found"), kAfterSearch);
  EXPECT_EQ(ending.code, ExitCode::kSafetyStop);
  EXPECT_EQ(ending.next, "echomap explore");
}

TEST(SourceReport, WithoutAnyMapIsUnsure) {
  const Report report = source_report(nullptr);
  EXPECT_EQ(report, Report({{"verdict", "unsure"}}));
  const RunEnding ending =
      ending_of_search(drive_of("nowhere-to-go", ExitCode::kUnfinished), report, kAfterSearch);
  EXPECT_EQ(ending.code, ExitCode::kUnfinished);
  EXPECT_THAT(ending.why, HasSubstr("nothing was read"));
}

TEST(SourceReport, SaysWhoOfAFleetHasFoundIt) {
  const fleet_messages::SearchReport said{
      source_search::SourceVerdict::kFound, 0.957, {9.0, 9.0}, 19.5, {}};
  const RunEnding joined =
      ending_of_search(drive_of("complete", ExitCode::kUnfinished),
                       told_report({"robot1", said, Eigen::Vector2d(2.0, 1.0)}),
                       kAfterSearch);
  EXPECT_EQ(joined.code, ExitCode::kOk);
  EXPECT_EQ(joined.outcome, "found");
  EXPECT_THAT(joined.why, HasSubstr("robot1 has found a source of 19.5 pulses/s"));
  EXPECT_THAT(joined.why, HasSubstr("(2.00, 1.00)"));
  const RunEnding apart = ending_of_search(drive_of("complete", ExitCode::kOk),
                                           told_report({"robot1", said, std::nullopt}),
                                           kAfterSearch);
  EXPECT_THAT(apart.why, HasSubstr("not joined to this one"));
  EXPECT_TRUE(told_report({"robot1", said, std::nullopt}).at("best_m").is_null());
}

TEST(SourceReport, SaysWhoOfAFleetHasShownThatThereIsNone) {
  const fleet_messages::SearchReport said{
      source_search::SourceVerdict::kNone, 0.951, Eigen::Vector2d::Zero(), 0.0, {}};
  const RunEnding ending = ending_of_search(drive_of("complete", ExitCode::kOk),
                                            told_report({"robot2", said, std::nullopt}),
                                            kAfterSearch);
  EXPECT_EQ(ending.outcome, "none");
  EXPECT_THAT(ending.why, HasSubstr("robot2 has shown that there is no source"));
}

class SourceReportFiles : public ::testing::Test {
 protected:
  Report with_truth(Report report, const std::string& sources) {
    files::write_text_file(scratch / "source.json", R"({"sources": [)" + sources + "]}");
    add_source_truth(scratch / "source.json", report);
    return report;
  }

  const std::string near_source =
      R"({"kind": "radiation", "map_x_m": 2.0, "map_y_m": 1.1, "strength": 20.0})";
  const std::string far_source =
      R"({"kind": "radiation", "map_x_m": 3.0, "map_y_m": 1.0, "strength": 20.0})";
  const std::string lamp = R"({"kind": "light", "map_x_m": 2.0, "map_y_m": 1.0, "strength": 9.0})";
  tests::ScratchFolder scratch;
};

TEST_F(SourceReportFiles, AreComparedWithTheTruth) {
  const Report right = with_truth(report_of("found"), far_source + "," + near_source);
  EXPECT_EQ(right.at("truth").at("right"), true);
  EXPECT_NEAR(right.at("truth").at("error_m"), 0.1, 1e-9);
  EXPECT_EQ(with_truth(report_of("found"), far_source).at("truth").at("right"), false);
  EXPECT_EQ(with_truth(report_of("found"), lamp).at("truth").at("right"), false);
  EXPECT_EQ(with_truth(report_of("none"), near_source).at("truth").at("right"), false);
  EXPECT_EQ(with_truth(report_of("none"), lamp).at("truth").at("right"), true);
  EXPECT_TRUE(with_truth(report_of("unsure"), near_source).at("truth").at("right").is_null());
}

TEST_F(SourceReportFiles, HaveNoTruthOfARobotOnADesk) {
  Report report = report_of("found");
  add_source_truth(scratch / "source.json", report);
  EXPECT_FALSE(report.contains("truth"));
}

TEST_F(SourceReportFiles, HaveTheDensityOfTheSource) {
  mapping::RasterMap map(20, 20, 0.05, {0.0, 0.0});
  for (int i = 0; i < 400; ++i) {
    map.set({i % 20, i / 20}, mapping::CellState::kFree);
  }
  const source_search::SourceBelief belief({}, map);
  write_source_density(scratch / "source_density.csv", belief);
  const std::string text = files::read_text_file(scratch / "source_density.csv");
  EXPECT_THAT(text, testing::StartsWith("x_m,y_m,density_per_m2\n0.025,0.025,"));
  EXPECT_EQ(source_report(&belief).at("verdict"), "unsure");
}

}  // namespace
}  // namespace echomap::apps

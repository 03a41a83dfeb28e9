// SPDX-License-Identifier: MIT
#include "host/paper_report/report_json.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/host/paper_report/sample_report.hpp"

namespace echomap::paper_report {
namespace {

nlohmann::json parsed(const PaperReport& report) {
  return nlohmann::json::parse(report_json(report, SourceLines(ECHOMAP_SOURCE_DIR)));
}

TEST(ReportJson, NamesItsFormatAndWhatRepeatsIt) {
  const auto json = parsed(sample_report());
  EXPECT_EQ(json["format"], "echomap-paper-report");
  EXPECT_EQ(json["version"], kReportJsonVersion);
  EXPECT_EQ(json["paper"]["number"], "000");
  EXPECT_EQ(json["echomap_version"], "0.1.0");
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["command"], "echomap paper 000 --seed 7 --out <folder>");
  EXPECT_EQ(json["confidence"], 0.95);
  EXPECT_EQ(json["experiments"].size(), 2U);
}

TEST(ReportJson, HasTheNumbersOfEveryFindingUnrounded) {
  const auto findings = parsed(sample_report())["experiments"][0]["findings"];
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0]["as_told"],
            nlohmann::json::parse(R"({"value":31.54,"low":24.96,"high":38.12,"runs":20})"));
  EXPECT_EQ(findings[0]["ours"]["value"], 3.04);
  EXPECT_EQ(findings[0]["unit"], "cm");
  EXPECT_EQ(findings[0]["where"], "figure 8");
  EXPECT_TRUE(findings[1]["as_told"].is_null());
  EXPECT_EQ(findings[1]["ours"]["low"], 100.0 * measured_share(20, 20).low);
}

TEST(ReportJson, HasNullForANumberThatIsNone) {
  PaperReport report = sample_report();
  report.experiments[0].findings[0].ours = measured_mean({});
  const auto ours = parsed(report)["experiments"][0]["findings"][0]["ours"];
  EXPECT_TRUE(ours["value"].is_null());
  EXPECT_EQ(ours["runs"], 0);
}

TEST(ReportJson, PlacesEquationsAndPictures) {
  const auto experiments = parsed(sample_report())["experiments"];
  EXPECT_EQ(experiments[0]["equations"][0]["file"], "host/paper_report/source_lines.hpp");
  EXPECT_TRUE(experiments[0]["equations"][0]["line"].is_number_integer());
  EXPECT_TRUE(experiments[0]["equations"][1]["line"].is_null());
  EXPECT_EQ(experiments[0]["pictures"][0]["file"], "01_particles_after_5_steps.png");
  EXPECT_EQ(experiments[1]["pictures"][0]["file"], "02_a_scan_of_the_room.png");
}

TEST(ReportJson, ReplacesBytesThatAreNoUtf8) {
  PaperReport report = sample_report();
  report.title = "a\xff";
  EXPECT_EQ(parsed(report)["paper"]["title"], "a\xEF\xBF\xBD");
}

TEST(PictureFileName, HasLettersDigitsAndUnderscores) {
  EXPECT_EQ(picture_file_name(3, "Posterior, as in figure 8 (MCL)"),
            "03_posterior_as_in_figure_8_mcl.png");
  EXPECT_EQ(picture_file_name(12, "../σ/ÄB"), "12_b.png");
  EXPECT_EQ(picture_file_name(4, "…"), "04_picture.png");
  EXPECT_EQ(picture_file_name(1, std::string(300, 'x')), "01_" + std::string(60, 'x') + ".png");
}

}  // namespace
}  // namespace echomap::paper_report

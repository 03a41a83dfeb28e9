// SPDX-License-Identifier: MIT
#include "tests/benchmarks/carried_runs.hpp"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::bench {
namespace {

constexpr double kHalfTurnRad = geometry::radians(180.0);

ToldPlace told(bool is_localized, double lost_probability, double error_m) {
  return {is_localized, lost_probability, evaluation::PlaceError{error_m, 0.0}};
}

const ToldPlace kRightClaim = told(true, 0.0, 0.05);
const ToldPlace kWrongClaim = told(true, 0.0, 2.0);
const ToldPlace kLost = {false, 1.0, std::nullopt};

CarriedRun run_of(std::optional<double> symmetry_rad,
                  const std::string& ended,
                  const std::vector<ToldPlace>& places) {
  return {symmetry_rad ? "hall" : "office", symmetry_rad, 1, "", ended, places};
}

std::optional<double> value_of(const std::vector<CarriedRun>& runs, const std::string& name) {
  for (const Figure& figure : carried_figures(runs)) {
    if (figure.name == name) {
      return figure.value;
    }
  }
  return std::nullopt;
}

TEST(CarriedRuns, CountsThoseFoundWhereNothingLooksAlike) {
  const std::vector<CarriedRun> runs{run_of({}, "localized", {kLost, kRightClaim}),
                                     run_of({}, "localized", {kLost, kWrongClaim}),
                                     run_of({}, "ambiguous", {told(false, 0.5, 0.0)}),
                                     run_of({}, "not localized", {kLost}),
                                     run_of(kHalfTurnRad, "localized", {kRightClaim})};
  EXPECT_EQ(value_of(runs, "own_map_found"), 0.25);
}

TEST(CarriedRuns, CountsClaimsAtEveryStop) {
  EXPECT_FALSE(told(false, 0.0, 2.0).is_claim());
  EXPECT_FALSE(told(true, 0.06, 2.0).is_claim());
  EXPECT_FALSE((ToldPlace{true, 0.0, std::nullopt}.is_right()));
  const std::vector<CarriedRun> runs{
      run_of({}, "localized", {kWrongClaim, kLost, kRightClaim, kRightClaim}),
      run_of(kHalfTurnRad, "localized", {told(true, 0.08, 2.0), kRightClaim})};
  EXPECT_EQ(value_of(runs, "wrong_claims"), 0.25);
}

TEST(CarriedRuns, CountsWhatIsToldAsAmbiguousOrRightlyClaimedWhereItLooksAlike) {
  const std::vector<CarriedRun> runs{
      run_of(kHalfTurnRad, "ambiguous", {told(false, 0.5, 3.0)}),
      run_of(kHalfTurnRad, "localized", {kRightClaim}),
      run_of(kHalfTurnRad, "localized", {kWrongClaim}),
      run_of(kHalfTurnRad, "ambiguous", {kWrongClaim, told(false, 0.5, 3.0)}),
      run_of({}, "ambiguous", {told(false, 0.5, 3.0)})};
  EXPECT_EQ(value_of(runs, "ambiguous_told"), 0.5);
}

TEST(CarriedRuns, ComparesProbabilitiesWithWhatHappened) {
  const std::vector<CarriedRun> fair{
      run_of({}, "ambiguous", {told(false, 0.5, 3.0), told(false, 0.5, 0.0), kLost, kRightClaim})};
  EXPECT_NEAR(value_of(fair, "reliability_gap").value(), 0.0, 1e-12);
  EXPECT_NEAR(
      value_of({run_of({}, "localized", {kWrongClaim, kRightClaim})}, "reliability_gap").value(),
      0.5,
      1e-12);
}

TEST(CarriedRuns, LeavesOutWhatWasNotCarriedOffAndSaysSo) {
  CarriedRun missing;
  missing.room = "office";
  missing.why_not = "no finished map (stuck)";
  const std::vector<CarriedRun> runs{missing, run_of({}, "localized", {kRightClaim})};
  EXPECT_EQ(value_of(runs, "own_map_found"), 1.0);
  EXPECT_EQ(value_of(runs, "carried_not_run"), 1.0);
  EXPECT_FALSE(value_of(runs, "ambiguous_told"));
  EXPECT_FALSE(value_of({missing}, "reliability_gap"));
  const auto table = carried_table(runs);
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0].back(), "1: no finished map (stuck)");
  EXPECT_EQ(table.rows[0][2], "1 of 1");
}

TEST(CarriedRuns, ReadsWhatTheDemoReports) {
  const auto run = read_carried({"hall", kHalfTurnRad, 3, "", "", {}},
                                R"({"kidnap": {"carried_m": 1.2, "ended": "ambiguous",
      "stops_told": [{"status": "lost", "lost_probability": 0.9, "error_m": null,
                      "heading_error_rad": null, "places": 0},
                     {"status": "localized", "lost_probability": 0.3, "error_m": 0.2,
                      "heading_error_rad": 0.5, "places": 1}]}})");
  EXPECT_TRUE(run.has_run());
  EXPECT_EQ(run.symmetry_rad, kHalfTurnRad);
  EXPECT_EQ(run.ended, "ambiguous");
  ASSERT_EQ(run.told.size(), 2U);
  EXPECT_FALSE(run.told[0].error);
  EXPECT_TRUE(run.told[1].is_localized);
  EXPECT_FALSE(run.told[1].is_right());
}

TEST(CarriedRuns, SaysWhyThereIsNone) {
  const auto why_not = [](const std::string& json) { return read_carried({}, json).why_not; };
  EXPECT_EQ(why_not(R"({"outcome": "stuck"})"), "no finished map (stuck)");
  EXPECT_EQ(why_not(R"({"kidnap": {"carried_m": null, "stops_told": []}})"),
            "the drive ended before");
  EXPECT_EQ(why_not(R"({"kidnap": {"carried_m": 0.1, "stops_told": [{}]}})"),
            "no other place in the room");
}

}  // namespace
}  // namespace echomap::bench

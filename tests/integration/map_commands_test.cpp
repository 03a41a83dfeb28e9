// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/exports/run_directory.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/told_snapshot.hpp"
#include "tests/support/truth_files.hpp"

namespace echomap::test {
namespace {

using files::read_text_file;
using files::write_text_file;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr int kOccupied = 400;
constexpr int kFree = -400;

/// A room of 2.5 x 2 m around the start, with a box in it or without.
mapping::OccupancyGrid room(bool with_box) {
  mapping::OccupancyGrid grid;
  for (int y = -15; y < 25; ++y) {
    for (int x = -20; x < 30; ++x) {
      const bool is_wall = x == -20 || x == 29 || y == -15 || y == 24 || (x < -10 && y == 5);
      const bool is_box = with_box && x >= 10 && x < 17 && y >= 5 && y < 12;
      const bool is_edge = is_box && (x == 10 || x == 16 || y == 5 || y == 11);
      if (is_box && !is_edge) {
        continue;
      }
      grid.add({x, y}, is_wall || is_edge ? kOccupied : kFree);
    }
  }
  return grid;
}

class MapCommands : public ::testing::Test {
 protected:
  MapCommands() {
    const std::vector<pipeline::StampedPose> path{
        tests::pose_at(0.0, {0.0, 0.0, 0.0}),
        tests::pose_at(5.0, {0.5, 0.0, 0.0}),
        tests::pose_at(10.0, {1.0, 0.0, 0.1}),
    };
    exports::write_run_directory(scratch / "before", tests::snapshot_of(room(false), path), {});
    exports::write_run_directory(scratch / "after", tests::snapshot_of(room(true), path), {});
    tests::write_truth_files(scratch / "truth");
  }
  Ended echomap(std::vector<std::string> arguments) {
    return Program("echomap", std::move(arguments), scratch / "log").wait();
  }
  std::string at(const std::string& name) const { return (scratch / name).string(); }
  nlohmann::json report() const {
    return nlohmann::json::parse(read_text_file(scratch / "report.json"));
  }

  tests::ScratchFolder scratch;
};

TEST_F(MapCommands, DiffFindsTheBoxThatAppeared) {
  const Ended ended = echomap({"diff",
                               at("before"),
                               at("after"),
                               "--picture=" + at("changes.png"),
                               "--json=" + at("report.json")});
  ASSERT_EQ(ended.status, 0) << ended.said;
  EXPECT_THAT(ended.said, HasSubstr("appeared at 0.6"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "changes.png"));
  const auto regions = report().at("regions");
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].at("change"), "appeared");
  EXPECT_NEAR(regions[0].at("x_m").get<double>(), 0.675, 0.06);
  EXPECT_NEAR(regions[0].at("y_m").get<double>(), 0.425, 0.06);
  EXPECT_GT(regions[0].at("confidence"), 0.65);
}

TEST_F(MapCommands, DiffOfARunWithItselfIsNothing) {
  const Ended ended = echomap({"diff", at("after"), at("after"), "--json=" + at("report.json")});
  ASSERT_EQ(ended.status, 0) << ended.said;
  EXPECT_THAT(ended.said, HasSubstr("nothing has changed"));
  EXPECT_TRUE(report().at("regions").empty());
}

TEST_F(MapCommands, DiffSaysWhatItCannotCompare) {
  EXPECT_EQ(echomap({"diff", at("before")}).status, 2);
  EXPECT_EQ(echomap({"diff", at("before"), at("nowhere")}).status, 2);
  const Ended no_map = echomap({"diff", at("before"), at("truth")});
  EXPECT_EQ(no_map.status, 1);
  EXPECT_THAT(no_map.said, HasSubstr("map.yaml"));
  exports::write_run_directory(scratch / "empty", tests::snapshot_of(mapping::OccupancyGrid()), {});
  const Ended nothing_shared = echomap({"diff", at("before"), at("empty")});
  EXPECT_EQ(nothing_shared.status, 1);
  EXPECT_THAT(nothing_shared.said, AllOf(HasSubstr("nothing in common"), HasSubstr("next: ")));
}

TEST_F(MapCommands, EvalDrawsTheErrorsAndScoresRelations) {
  write_text_file(scratch / "known.assoc", "0 1 0.5 0 0\n0 2 1 0 0\n");
  const Ended ended = echomap({"eval",
                               at("before"),
                               "--truth=" + at("truth"),
                               "--relations=" + at("known.assoc"),
                               "--picture=" + at("errors.png"),
                               "--json=" + at("report.json")});
  ASSERT_EQ(ended.status, 0) << ended.said;
  EXPECT_TRUE(std::filesystem::exists(scratch / "errors.png"));
  EXPECT_GT(report().at("free_iou"), 0.0);
  EXPECT_EQ(report().at("relations"), 2);
  EXPECT_NEAR(report().at("relation_rotation_mean_rad").get<double>(), 0.05, 1e-6);
}

TEST_F(MapCommands, EvalRefusesTheTruthOfAnotherRoom) {
  write_text_file(scratch / "before/summary.json", R"({"world": "living_room"})");
  write_text_file(scratch / "truth/truth.json", R"({"world": "create_l"})");
  const Ended ended = echomap({"eval", at("before"), "--truth=" + at("truth")});
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.said, AllOf(HasSubstr("'living_room'"), HasSubstr("'create_l'")));
}

TEST_F(MapCommands, EvalScoresRelationsWithoutATruth) {
  write_text_file(scratch / "known.assoc", "0 1 0.5 0 0\n");
  const std::string relations = "--relations=" + at("known.assoc");
  ASSERT_EQ(echomap({"eval", at("before"), relations, "--json=" + at("report.json")}).status, 0);
  EXPECT_NEAR(report().at("relation_translation_mean_m").get<double>(), 0.0, 1e-6);
  EXPECT_FALSE(report().contains("free_iou"));
  write_text_file(scratch / "known.assoc", "0 99 0.5 0 0\n");
  const Ended out_of_range = echomap({"eval", at("before"), relations});
  EXPECT_EQ(out_of_range.status, 1);
  EXPECT_THAT(out_of_range.said, HasSubstr("record 99"));
}

TEST_F(MapCommands, EvalWantsTruthOrRelationsAndATruthToDrawOn) {
  EXPECT_EQ(echomap({"eval", at("before")}).status, 2);
  write_text_file(scratch / "known.assoc", "0 1 0.5 0 0\n");
  EXPECT_EQ(echomap({"eval",
                     at("before"),
                     "--relations=" + at("known.assoc"),
                     "--picture=" + at("errors.png")})
                .status,
            2);
}

}  // namespace
}  // namespace echomap::test

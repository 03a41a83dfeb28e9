// SPDX-License-Identifier: MIT
#include "host/evaluation/relation_error.hpp"

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/datasets/line_reader.hpp"
#include "host/exports/number_table.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "tests/support/log_files.hpp"
#include "tests/support/real_data.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::evaluation {
namespace {

using geometry::Pose2;
using ::testing::HasSubstr;

/// A packed file of a public log, as plain text in the scratch folder.
std::filesystem::path unpacked(const std::filesystem::path& packed,
                               const tests::ScratchFolder& folder) {
  std::string text;
  datasets::LineReader lines(packed);
  while (const auto line = lines.next()) {
    text += *line;
    text += '\n';
  }
  const auto path = folder / packed.stem().string();
  files::write_text_file(path, text);
  return path;
}

/// One pose a line; the last three of `columns` are x, y and heading.
std::vector<Pose2> read_poses(const std::filesystem::path& path, std::size_t columns) {
  std::vector<Pose2> poses;
  for (const auto& row : exports::read_number_table(path, {"", ' ', columns})) {
    const auto* last = row.values.data() + columns - 3;
    poses.emplace_back(last[0], last[1], last[2]);
  }
  return poses;
}

RelationError score_public_log(const std::string& log,
                               const std::string& poses,
                               std::size_t columns,
                               const tests::ScratchFolder& folder) {
  const auto relations = tests::real_data("slam_relations/" + log + ".assoc.gz");
  const auto trajectory = unpacked(tests::real_data("slam_relations/" + poses), folder);
  return score_relations(read_poses(trajectory, columns), read_relations(relations));
}

TEST(RelationError, IsNothingForATrajectoryThatIsRightInAnyFrame) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-3.0, 3.0);
  std::vector<Pose2> truth;
  for (int i = 0; i < 50; ++i) {
    truth.emplace_back(any(random), any(random), any(random));
  }
  std::vector<PoseRelation> relations;
  for (std::size_t i = 0; i + 7 < truth.size(); ++i) {
    relations.push_back({i, i + 7, truth[i].inverse() * truth[i + 7]});
  }
  const Pose2 T_map_world(1.0, -2.0, 2.5);
  std::vector<Pose2> estimate;
  for (const Pose2& pose : truth) {
    estimate.push_back(T_map_world * pose);
  }
  const auto error = score_relations(estimate, relations);
  EXPECT_EQ(error.relations, 43U);
  EXPECT_NEAR(error.translation_mean_m, 0.0, 1e-12);
  EXPECT_NEAR(error.rotation_mean_rad, 0.0, 1e-12);
}

TEST(RelationError, IsMeanAndDeviationOfDistanceAndTurn) {
  const std::vector<Pose2> trajectory{{0, 0, 0}, {1.1, 0, 0}, {1.1, 0, 0.2}};
  const auto error = score_relations(trajectory, {{0, 1, {1, 0, 0}}, {1, 2, {0.3, 0, -0.1}}});
  EXPECT_NEAR(error.translation_mean_m, 0.2, 1e-12);
  EXPECT_NEAR(error.translation_stddev_m, 0.1, 1e-12);
  EXPECT_NEAR(error.rotation_mean_rad, 0.15, 1e-12);
  EXPECT_NEAR(error.rotation_stddev_rad, 0.15, 1e-12);
}

TEST(RelationError, OfEdmontonsOdometryIsTheKnownOne) {
  ECHOMAP_SKIP_WITHOUT(tests::real_data("slam_relations/edm.odo.gz"));
  const tests::ScratchFolder folder;
  const auto error = score_public_log("edm", "edm.odo.gz", 5, folder);
  EXPECT_EQ(error.relations, 612U);
  EXPECT_NEAR(error.translation_mean_m, 0.262, 0.0005);
  EXPECT_NEAR(geometry::degrees(error.rotation_mean_rad), 2.20, 0.005);
}

TEST(RelationError, OfFreiburgsCorrectedPosesIsTheKnownOne) {
  ECHOMAP_SKIP_WITHOUT(tests::real_data("slam_relations/fr079.cor.gz"));
  const tests::ScratchFolder folder;
  const auto error = score_public_log("fr079", "fr079.cor.gz", 4, folder);
  EXPECT_EQ(error.relations, 1685U);
  EXPECT_NEAR(error.translation_mean_m, 0.0581, 0.00005);
  EXPECT_NEAR(error.translation_stddev_m, 0.0418, 0.00005);
  EXPECT_NEAR(geometry::degrees(error.rotation_mean_rad), 0.71, 0.005);
}

TEST(RelationError, NeedsRelationsBetweenRecordsThatAreThere) {
  EXPECT_THROW(score_relations({{0, 0, 0}}, {}), std::invalid_argument);
  EXPECT_THROW(score_relations({{0, 0, 0}}, {{0, 1, {}}}), std::invalid_argument);
}

TEST(RelationFile, MayBePacked) {
  const tests::ScratchFolder folder;
  tests::write_gz(folder / "a.assoc.gz", "# from to dx dy dtheta\n3 7 0.5 -0.25 0.125\n");
  const auto relations = read_relations(folder / "a.assoc.gz");
  ASSERT_EQ(relations.size(), 1U);
  EXPECT_EQ(relations[0].from, 3U);
  EXPECT_EQ(relations[0].to, 7U);
  EXPECT_EQ(relations[0].T_from_to.y_m(), -0.25);
}

TEST(RelationFile, SaysWhichLineIsWrong) {
  const tests::ScratchFolder folder;
  const auto complaint_about = [&](const std::string& text) {
    files::write_text_file(folder / "a.assoc", text);
    return tests::thrown_text<files::FileError>([&] { read_relations(folder / "a.assoc"); });
  };
  EXPECT_THAT(complaint_about("0 1 0 0 0\n0 1 0 0\n"), HasSubstr("a.assoc:2: expected 5"));
  EXPECT_THAT(complaint_about("0 1.5 0 0 0\n"), HasSubstr("a.assoc:1: records"));
  EXPECT_THAT(complaint_about("-1 1 0 0 0\n"), HasSubstr("a.assoc:1: records"));
  EXPECT_THAT(complaint_about("0 1e300 0 0 0\n"), HasSubstr("a.assoc:1: records"));
  EXPECT_THAT(complaint_about("0 1 nan 0 0\n"), HasSubstr("a.assoc:1: "));
}

}  // namespace
}  // namespace echomap::evaluation

// SPDX-License-Identifier: MIT
#include "host/datasets/mrclam_team.hpp"

#include <algorithm>

#include <gmock/gmock.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/team_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::datasets {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class MrclamTeam : public ::testing::Test {
 protected:
  MrclamTeam() { tests::write_team_folder(folder_.path()); }

  void put(const std::string& file, const std::string& text) {
    files::write_text_file(folder_ / file, text);
  }
  TeamLog read() { return read_mrclam_team(folder_.path()); }
  std::string error() {
    return tests::thrown_text<files::FileError>([&] { read(); });
  }

  tests::ScratchFolder folder_;
};

TEST_F(MrclamTeam, IsAllRobotsOfTheFolderAndItsLandmarks) {
  const TeamLog team = read();
  EXPECT_THAT(team.robots, ElementsAre(1, 2));
  ASSERT_EQ(team.landmarks_m.size(), 1U);
  EXPECT_EQ(team.landmarks_m.at(6), Eigen::Vector2d(12.0, 0.0));
  EXPECT_THAT(team.notes, IsEmpty());
  EXPECT_TRUE(std::ranges::is_sorted(team.records, {}, &TeamRecord::stamp_s));
}

TEST_F(MrclamTeam, StampsAreOfWhenThingsHappened) {
  put("Robot1_Odometry.dat", "10 1 1\n11 0 0\n");
  put("Robot1_Groundtruth.dat", "10 0 0 0\n");
  put("Robot1_Measurement.dat", "10.5 72 3 0.1\n10.5 14 2 0.2\n");
  double moved_s = 0.0;
  std::vector<double> seen_s;
  for (const TeamRecord& record : read().records) {
    if (record.robot == 2) {
      continue;
    }
    if (const auto* step = std::get_if<OdometryStep>(&record.record)) {
      moved_s = record.stamp_s;
      EXPECT_DOUBLE_EQ(step->T_last_now.heading_rad(), moved_s > 11.0 ? 0.93 : 0.0);
    } else if (std::holds_alternative<LandmarkSighting>(record.record)) {
      seen_s.push_back(record.stamp_s);
    }
  }
  EXPECT_DOUBLE_EQ(moved_s, 11.2);
  EXPECT_THAT(seen_s, ElementsAre(DoubleEq(10.45), DoubleEq(10.45))) << "one picture";
}

TEST_F(MrclamTeam, ARobotAloneIsNoTeam) {
  std::filesystem::remove(folder_ / "Robot2_Odometry.dat");
  EXPECT_THAT(error(), HasSubstr("it has 1 of the files RobotN_Odometry.dat"));
  std::filesystem::remove(folder_ / "Robot1_Odometry.dat");
  EXPECT_THAT(error(), HasSubstr("it has 0 of"));
}

TEST_F(MrclamTeam, ErrorsNameTheFileThatIsMissing) {
  std::filesystem::remove(folder_ / "Robot2_Measurement.dat");
  EXPECT_THAT(error(), HasSubstr("Robot2_Measurement.dat"));
  tests::write_team_folder(folder_.path());
  std::filesystem::remove(folder_ / "Landmark_Groundtruth.dat");
  EXPECT_THAT(error(), HasSubstr("Landmark_Groundtruth.dat"));
}

TEST_F(MrclamTeam, ErrorsNameTheLineThatIsWrong) {
  put("Landmark_Groundtruth.dat", "6 12 0 0 0\n7 12 x 0 0\n");
  EXPECT_THAT(error(), HasSubstr("Landmark_Groundtruth.dat:2: y is 'x'"));
  tests::write_team_folder(folder_.path());
  put("Robot2_Odometry.dat", "10 1 1\n11 1\n12 1 1\n");
  EXPECT_THAT(error(), HasSubstr("Robot2_Odometry.dat:2: "));
}

TEST_F(MrclamTeam, ALineThatIsCutOffIsNoted) {
  put("Robot1_Odometry.dat", "10 1 1\n11 1 1\n12 0.");
  const TeamLog team = read();
  ASSERT_EQ(team.notes.size(), 1U);
  EXPECT_THAT(team.notes[0], HasSubstr("Robot1_Odometry.dat:3"));
}

TEST_F(MrclamTeam, OtherFilesAreLeftAlone) {
  put("RobotX_Odometry.dat", "x");
  put("Robot3_Odometry.dat.bak", "x");
  put("notes.txt", "x");
  EXPECT_THAT(read().robots, ElementsAre(1, 2));
}

}  // namespace
}  // namespace echomap::datasets

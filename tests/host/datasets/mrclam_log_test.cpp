// SPDX-License-Identifier: MIT
#include "host/datasets/mrclam_log.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "tests/support/log_test.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::datasets {
namespace {

using ::testing::HasSubstr;

class MrclamLogTest : public tests::LogTest {
 protected:
  MrclamLogTest() : LogTest("Robot1_Odometry.dat", open_mrclam_log) {
    put("Barcodes.dat", "# Subject # Barcode #\n1 5\n6 72\n");
    put("Robot1_Measurement.dat", "# Time barcode r b\n10.5 72 2 0.25\n10.5 5 1 0\n10.6 3 1 1\n");
  }
};

TEST_F(MrclamLogTest, ASpeedHoldsUntilTheNextOne) {
  const auto steps = tests::only<OdometryStep>(read("# t v w\n10 0.5 0\n12 1 0.5\n13 0 0\n"));
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[0].T_last_now.x_m(), 0.0);
  EXPECT_EQ(steps[1].T_last_now.x_m(), 1.0);
  // An arc of 1 m that turns by 0.5 rad.
  EXPECT_DOUBLE_EQ(steps[2].T_last_now.heading_rad(), 0.5);
  EXPECT_NEAR(steps[2].T_last_now.x_m(), 2.0 * std::sin(0.5), 1e-12);
  EXPECT_NEAR(steps[2].T_last_now.y_m(), 2.0 * (1.0 - std::cos(0.5)), 1e-12);
}

TEST_F(MrclamLogTest, SightingsAreOfSubjectsAndUnknownBarcodesAreLeftOut) {
  const auto sightings = tests::only<LandmarkSighting>(read("10 0 0\n"));
  ASSERT_EQ(sightings.size(), 2U);
  EXPECT_EQ(sightings[0].id, 6);
  EXPECT_EQ(sightings[0].stamp_s, 10.5);
  EXPECT_EQ(sightings[0].bearing_rad, 0.25);
  EXPECT_EQ(sightings[1].id, 1);
}

TEST_F(MrclamLogTest, RecordsOfItsFilesComeInTheOrderOfTheirStamps) {
  put("Robot1_Groundtruth.dat", "9 1 2 3\n10.55 1 2 3\n");
  const auto records = read("10 0 0\n11 0 0\n");
  ASSERT_EQ(records.size(), 6U);
  EXPECT_TRUE(std::holds_alternative<GivenPose>(records[0]));
  EXPECT_TRUE(std::holds_alternative<OdometryStep>(records[1]));
  EXPECT_TRUE(std::holds_alternative<LandmarkSighting>(records[2]));
  EXPECT_TRUE(std::holds_alternative<LandmarkSighting>(records[3]));
  EXPECT_TRUE(std::holds_alternative<GivenPose>(records[4]));
  EXPECT_TRUE(std::holds_alternative<OdometryStep>(records[5]));
}

TEST_F(MrclamLogTest, ErrorsNameTheFileThatIsWrong) {
  EXPECT_THAT(error_of("10 0 0 0\n"), HasSubstr("Robot1_Odometry.dat:1: '0' follows"));
  put("Barcodes.dat", "1 x\n");
  EXPECT_THAT(error_of("10 0 0\n"), HasSubstr("Barcodes.dat:1: the barcode is 'x'"));
  std::filesystem::remove(folder_ / "Robot1_Measurement.dat");
  EXPECT_THAT(error_of("10 0 0\n"), HasSubstr("Robot1_Measurement.dat"));
}

TEST(RealMrclamLog, ItsOdometryIsAsLongAsItsTruth) {
  const auto path = tests::real_data("utias_mrclam/MRCLAM_Dataset6/Robot2_Odometry.dat.gz");
  ECHOMAP_SKIP_WITHOUT(path);
  double odometry_m = 0.0;
  double truth_m = 0.0;
  std::optional<Eigen::Vector2d> last_m;
  std::size_t sightings = 0;
  for (const auto& record : tests::records_of(*open_mrclam_log(path))) {
    if (const auto* step = std::get_if<OdometryStep>(&record)) {
      odometry_m += step->T_last_now.position_m().norm();
    } else if (const auto* given = std::get_if<GivenPose>(&record)) {
      truth_m += last_m ? (given->T_map_robot.position_m() - *last_m).norm() : 0.0;
      last_m = given->T_map_robot.position_m();
    } else {
      ++sightings;
    }
  }
  EXPECT_GT(truth_m, 38.0);
  EXPECT_NEAR(odometry_m / truth_m, 1.0, 0.07);
  EXPECT_GT(sightings, 1900U);
}

}  // namespace
}  // namespace echomap::datasets

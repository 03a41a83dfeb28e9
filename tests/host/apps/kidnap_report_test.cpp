// SPDX-License-Identifier: MIT
#include "host/apps/kidnap_report.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/geometry/angle.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::apps {
namespace {

using geometry::Pose2;
using localization::LocalizationStatus;
using testing::HasSubstr;
using tests::pose_at;

/// A robot that explored from (1, 1) of the world to (3, 1), and was carried from there to (2, 2).
class KidnapReport : public ::testing::Test {
 protected:
  KidnapReport() {
    for (int i = 0; i <= 2; ++i) {
      kidnap.explored.push_back(pose_at(i, {1.0 * i, 0.0, 0.0}));
      truth.push_back({pose_at(i, {}).stamp, {1.0 + i, 1.0, 0.0}});
    }
    truth.push_back({pose_at(9.0, {}).stamp, {3.0, 1.0, 0.0}});
    truth.push_back({pose_at(9.02, {}).stamp, {2.0, 2.0, 0.0}});
    truth.push_back({pose_at(99.0, {}).stamp, {2.0, 2.0, 0.0}});
    kidnap.is_noticed = true;
  }

  /// The robot truly is at (1, 1) of its own map.
  void tell(LocalizationStatus status,
            double lost_probability,
            const Pose2& T_map_robot,
            std::size_t places) {
    const double stamp_s = 10.0 + static_cast<double>(kidnap.stops.size());
    kidnap.stops.push_back({status, lost_probability, pose_at(stamp_s, T_map_robot), places});
  }

  nlohmann::ordered_json report() const { return kidnap_report(kidnap, truth); }

  DemoKidnap kidnap;
  std::vector<evaluation::TruePose> truth;
};

TEST_F(KidnapReport, MeasuresARobotThatIsFoundInItsOwnMap) {
  tell(LocalizationStatus::kLost, 0.9, {0.0, 1.0, 0.0}, 2);
  tell(LocalizationStatus::kLocalized, 0.02, {1.03, 1.04, geometry::radians(5.0)}, 1);
  const auto json = report();
  EXPECT_TRUE(json.at("noticed"));
  EXPECT_TRUE(json.at("found"));
  EXPECT_EQ(json.at("stops"), 2);
  EXPECT_EQ(json.at("ended"), "localized");
  EXPECT_NEAR(json.at("error_m"), 0.05, 1e-9);
  EXPECT_NEAR(json.at("heading_error_rad"), geometry::radians(5.0), 1e-9);
  EXPECT_NEAR(json.at("carried_m"), std::sqrt(2.0), 1e-9);
  const auto& first = json.at("stops_told").at(0);
  EXPECT_EQ(first.at("status"), "lost");
  EXPECT_EQ(first.at("lost_probability"), 0.9);
  EXPECT_NEAR(first.at("error_m"), 1.0, 1e-9);
  EXPECT_EQ(first.at("places"), 2);
  EXPECT_EQ(kidnap_line(json), "carried off: after 2 stops it was relocalized, 5 cm off");
}

TEST_F(KidnapReport, SaysThatAClaimIsWrong) {
  tell(LocalizationStatus::kLocalized, 0.01, {2.0, 1.0, 0.0}, 1);
  EXPECT_FALSE(report().at("found"));
  EXPECT_EQ(report().at("ended"), "localized");
  EXPECT_THAT(kidnap_line(report()), HasSubstr("after 1 stop it claimed a wrong place, 100 cm"));
}

TEST_F(KidnapReport, CallsARightPlaceThatIsNotCloseRelocalizedAndNotFound) {
  tell(LocalizationStatus::kLocalized, 0.01, {1.2, 1.0, 0.0}, 1);
  EXPECT_FALSE(report().at("found"));
  EXPECT_THAT(kidnap_line(report()), HasSubstr("was relocalized, 20 cm off"));
}

TEST_F(KidnapReport, TellsAmbiguousFromNotLocalized) {
  tell(LocalizationStatus::kRecovering, 0.5, {1.0, 1.0, 0.0}, 2);
  EXPECT_EQ(report().at("ended"), "ambiguous");
  EXPECT_TRUE(report().at("error_m").is_null());
  EXPECT_THAT(kidnap_line(report()), HasSubstr("cannot tell 2 places from each other"));
  tell(LocalizationStatus::kRecovering, 0.2, {1.0, 1.0, 0.0}, 1);
  EXPECT_EQ(report().at("ended"), "not localized");
  EXPECT_THAT(kidnap_line(report()), HasSubstr("still does not know where it is"));
}

TEST_F(KidnapReport, DoesNotCallItRightThatItDroveNoFurther) {
  tell(LocalizationStatus::kRecovering, 0.5, {1.0, 1.0, 0.0}, 2);
  EXPECT_TRUE(report().at("gave_up").is_null());
  EXPECT_THAT(kidnap_line(report()), HasSubstr("which is right"));
  kidnap.gave_up = exploration::FinishReason::kNowhereToGo;
  EXPECT_EQ(report().at("gave_up"), "nowhere-to-go");
  EXPECT_EQ(
      kidnap_line(report()),
      "carried off: after 1 stop it drove no further (nowhere-to-go) and cannot tell 2 places "
      "from each other");
}

TEST_F(KidnapReport, HasNoErrorWhereNoPlaceWasTold) {
  kidnap.stops.push_back({LocalizationStatus::kLost, 1.0, std::nullopt, {}});
  EXPECT_TRUE(report().at("stops_told").at(0).at("error_m").is_null());
  EXPECT_EQ(report().at("stops_told").at(0).at("places"), 0);
}

TEST_F(KidnapReport, IsOfNoStopWhereTheSessionEndedBefore) {
  const auto json = report();
  EXPECT_FALSE(json.at("found"));
  EXPECT_TRUE(json.at("carried_m").is_null());
  EXPECT_EQ(json.at("ended"), "not localized");
  EXPECT_TRUE(json.at("stops_told").empty());
  EXPECT_EQ(kidnap_line(json), "carried off: the run ended before it could look around");
}

}  // namespace
}  // namespace echomap::apps

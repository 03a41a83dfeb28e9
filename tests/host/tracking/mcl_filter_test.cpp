// SPDX-License-Identifier: MIT
#include "host/tracking/mcl_filter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/host/session/session_on_a_cable.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::tracking {
namespace {

using localization::LocalizerPreset;
using ::testing::HasSubstr;

const mapping::RasterMap kRoom = tests::map_from(
    {"########", "#......#", "#......#", "#...####", "#......#", "#......#", "########"}, 0.2);

class MclFilterTest : public session::SessionOnACable {
 protected:
  MclFilter filter(const std::optional<StartPose>& start) {
    return MclFilter(kRoom,
                     profile.geometry,
                     localizer_params(profile, LocalizerPreset::kDefault),
                     start,
                     std::mt19937(1));
  }
};

TEST_F(MclFilterTest, BelievesTheUserAtFirst) {
  MclFilter told = filter(StartPose{{0.5, 0.4, 0.0}, 0.05, 0.05});
  told.begin(*session);
  told.sink().on_odometry({});
  EXPECT_EQ(told.report().at("status"), "localized");
  MclFilter untold = filter(std::nullopt);
  untold.begin(*session);
  EXPECT_TRUE(untold.report().at("hypotheses").empty());
}

TEST_F(MclFilterTest, HasLostARobotThatWasLifted) {
  MclFilter told = filter(StartPose{{0.5, 0.4, 0.0}, 0.05, 0.05});
  told.begin(*session);
  told.sink().on_odometry({});
  EXPECT_FALSE(told.has_lost_it());
  sensors::HazardObservation hazards;
  hazards.lifted = true;
  told.sink().on_hazards(hazards);
  told.poll(*session);
  EXPECT_TRUE(told.has_lost_it());
  EXPECT_FALSE(told.has_lost_it()) << "that was told already";
  EXPECT_EQ(told.report().at("times_lifted"), 1);
}

TEST_F(MclFilterTest, TakesTheSonarFromTheProfile) {
  const auto params = localizer_params(profile, LocalizerPreset::kNxt);
  EXPECT_EQ(params.preset, LocalizerPreset::kNxt);
  EXPECT_EQ(params.sensor->beam_half_angle_rad, profile.beam_half_angle_rad);
  EXPECT_EQ(params.sensor->max_range_m, profile.range.max_range_m);
}

TEST(LocalizerParams, GoByTheSensorThatTheRobotHas) {
  using localization::LocalizedBy;
  const auto sensor = [](const char* robot, LocalizerPreset preset) {
    return localizer_params(session::load_robot_profile(robot), preset).sensor->by;
  };
  EXPECT_EQ(sensor("uno_2wd", LocalizerPreset::kDefault), LocalizedBy::kSonar);
  EXPECT_EQ(sensor("epuck", LocalizerPreset::kEpuck), LocalizedBy::kInfrared);
  EXPECT_EQ(sensor("create", LocalizerPreset::kCreate), LocalizedBy::kContacts);
  const auto ring =
      localizer_params(session::load_robot_profile("epuck"), LocalizerPreset::kDefault);
  EXPECT_EQ(ring.T_robot_infrared.size(), 8U);
  EXPECT_DOUBLE_EQ(ring.sensor->max_range_m, 0.06);
  const auto nxt =
      localizer_params(session::load_robot_profile("nxt_tribot"), LocalizerPreset::kNxt);
  EXPECT_EQ(nxt.bearings_rad.size(), 8U) << "the paper's";
}

TEST(LocalizerParams, RefuseAPresetOfAnotherSensor) {
  const auto refusal = [](const char* robot, LocalizerPreset preset) {
    return tests::thrown_text<console::CommandError>(
        [&] { localizer_params(session::load_robot_profile(robot), preset); });
  };
  EXPECT_THAT(refusal("uno_2wd", LocalizerPreset::kCreate), HasSubstr("preset 'create' needs"));
  EXPECT_THAT(refusal("create", LocalizerPreset::kNxt), HasSubstr("a sonar"));
  EXPECT_THAT(refusal("epuck", LocalizerPreset::kNxt), HasSubstr("next: leave --preset out"));
  EXPECT_THAT(refusal("create", LocalizerPreset::kEpuck), HasSubstr("as epuck"));
}

}  // namespace
}  // namespace echomap::tracking

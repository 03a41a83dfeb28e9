// SPDX-License-Identifier: MIT
#include "host/tracking/mcl_filter.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/host/session/session_on_a_cable.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::tracking {
namespace {

using localization::LocalizerPreset;

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

}  // namespace
}  // namespace echomap::tracking

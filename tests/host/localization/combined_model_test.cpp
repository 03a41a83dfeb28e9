// SPDX-License-Identifier: MIT
#include "host/localization/combined_model.hpp"

#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "host/localization/contact_model.hpp"

namespace echomap::localization {
namespace {

const mapping::PolygonMap kWideRoom({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}});

/// A bumper at 10 cm of the robot's middle, and another at 20 cm.
CombinedModel two_bumpers() {
  std::vector<std::unique_ptr<ObservationModel>> models;
  models.push_back(std::make_unique<ContactModel>(kWideRoom, 0.1));
  models.push_back(std::make_unique<ContactModel>(kWideRoom, 0.2));
  return CombinedModel(std::move(models));
}

Particles before_the_wall() {
  Particles particles;
  particles.resize(1);
  particles.set_pose(0, {1.85, 0.5, 0.0});
  return particles;
}

TEST(CombinedModel, MultipliesTheLikelihoodsOfItsModels) {
  const models::ContactReading bump{true, true, false};
  float sum = 0.0F;
  for (const double radius_m : {0.1, 0.2}) {
    ContactModel alone(kWideRoom, radius_m);
    alone.add_contact(bump);
    alone.observe({});
    Particles particles = before_the_wall();
    alone.update_weights(0.5F, {0, 1}, particles);
    sum += particles.log_weight[0];
  }
  CombinedModel both = two_bumpers();
  both.add_contact(bump);
  both.observe({});
  Particles particles = before_the_wall();
  both.make_ready(particles, Workers());
  both.update_weights(0.5F, {0, 1}, particles);
  EXPECT_FLOAT_EQ(particles.log_weight[0], sum);
  EXPECT_LT(sum, 0.0F);
}

TEST(CombinedModel, CountsTheReadingsOfAllAndStandsOnTheFirstsFloor) {
  CombinedModel both = two_bumpers();
  both.observe({});
  EXPECT_EQ(both.count(), 2U);
  EXPECT_EQ(both.map().state(both.map().cell_at({1.0, 0.5})), mapping::CellState::kFree);
}

TEST(CombinedModel, RefusesNone) { EXPECT_THROW(CombinedModel({}), std::invalid_argument); }

}  // namespace
}  // namespace echomap::localization

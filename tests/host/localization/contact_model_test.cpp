// SPDX-License-Identifier: MIT
#include "host/localization/contact_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

constexpr double kRadiusM = 0.1;
const mapping::PolygonMap kBareRoom({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}});

/// The likeliest of poses that look along the x axis, by where they stand on it.
double likeliest_x_m(const models::ContactReading& reading) {
  ContactModel model(kBareRoom, kRadiusM);
  model.add_contact(reading);
  model.observe({});
  EXPECT_EQ(model.count(), 1U);
  Particles particles;
  particles.resize(240);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles.set_pose(i, {-0.195 + 0.01 * static_cast<double>(i), 0.5, 0.0});
  }
  model.update_weights(1.0F, {0, particles.size()}, particles);
  const auto best = std::max_element(particles.log_weight.begin(), particles.log_weight.end());
  return particles.x_m[static_cast<std::size_t>(best - particles.log_weight.begin())];
}

TEST(ContactModel, ABumpIsAWallAtTheBody) {
  EXPECT_NEAR(likeliest_x_m({true, true, true}), 1.9, 0.011);
}

TEST(ContactModel, LightIsAWallAhead) {
  EXPECT_GT(likeliest_x_m({false, false, true}), 1.9 - 0.375);
  EXPECT_LT(likeliest_x_m({}), 1.9 - 0.375);
}

TEST(ContactModel, RejectsWhatIsOutside) {
  ContactModel model(kBareRoom, kRadiusM);
  Particles particles;
  particles.resize(2);
  particles.set_pose(0, {1.0, 0.5, 0.0});
  particles.set_pose(1, {2.01, 0.5, 0.0});
  model.update_weights(1.0F, {0, 2}, particles);
  EXPECT_GT(particles.log_weight[0], -0.2F);
  EXPECT_LE(particles.log_weight[1], -1000.0F);
}

TEST(ContactModel, HasAFloorToStartFrom) {
  const ContactModel model(kBareRoom, kRadiusM);
  EXPECT_EQ(model.map().state(model.map().cell_at({1.0, 0.5})), mapping::CellState::kFree);
  EXPECT_NE(model.map().state(model.map().cell_at({1.0, 1.5})), mapping::CellState::kFree);
}

TEST(ContactModel, RefusesABodyWithoutSizeAndARoomWithoutFloor) {
  EXPECT_THROW(ContactModel(kBareRoom, 0.0), std::invalid_argument);
  EXPECT_THROW(ContactModel(kBareRoom, std::nan("")), std::invalid_argument);
  const mapping::PolygonMap crumb({{0.0, 0.0}, {0.01, 0.0}, {0.01, 0.01}, {0.0, 0.01}});
  EXPECT_THROW(ContactModel(crumb, kRadiusM), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization

// SPDX-License-Identifier: MIT
#include "host/localization/view_model.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "host/localization/point_cloud_view.hpp"
#include "host/localization/polygon_view.hpp"
#include "host/models/gaussian_range.hpp"
#include "host/models/infrared_range.hpp"

namespace echomap::localization {
namespace {

static_assert(RangeView<PointCloudView> && RangeView<PolygonView>);

const mapping::PolygonMap kSquareRoom({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}});

Particles particles_at(const std::vector<geometry::Pose2>& poses) {
  Particles particles;
  particles.resize(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    particles.set_pose(i, poses[i]);
  }
  return particles;
}

TEST(ViewModel, IsTheProductOfTheReadings) {
  const models::GaussianRange gaussian;
  ViewModel<PolygonView, models::GaussianRange> model(
      rasterize(kSquareRoom, 0.1), PolygonView(kSquareRoom, {.max_range_m = 2.0}), gaussian);
  const std::vector<RangeReading> readings{{{}, 0.52}, {{0.0, 0.0, 1.5707963}, 0.49}};
  model.observe(readings);
  ASSERT_EQ(model.count(), 2U);
  Particles particles = particles_at({{0.5, 0.5, 0.0}});
  model.make_ready(particles, Workers());
  model.update_weights(0.5F, {0, 1}, particles);
  const double one = gaussian.likelihood(0.52, {0.5, false});
  const double other = gaussian.likelihood(0.49, {0.5, false});
  EXPECT_NEAR(particles.log_weight[0], 0.5 * std::log(one * other), 1e-4);
}

TEST(ViewModel, RejectsWhatIsOutsideOfTheOutline) {
  ViewModel<PolygonView, models::InfraredRange> model(
      rasterize(kSquareRoom, 0.1), PolygonView(kSquareRoom), models::InfraredRange());
  const std::vector<RangeReading> silence(3);
  model.observe(silence);
  ASSERT_EQ(model.count(), 3U);
  Particles particles = particles_at({{0.5, 0.5, 0.0}, {1.1, 0.5, 0.0}});
  model.update_weights(1.0F, {0, 2}, particles);
  EXPECT_GT(particles.log_weight[0], -1.0F);
  EXPECT_EQ(particles.log_weight[1], kRejectedLog);
}

TEST(ViewModel, LooksAtAnyMapAlike) {
  std::vector<Eigen::Vector2d> points_m;
  for (int i = 0; i <= 100; ++i) {
    points_m.emplace_back(1.0, 0.01 * i);
  }
  const models::GaussianRange gaussian;
  ViewModel<PointCloudView, models::GaussianRange> cloud(
      rasterize(kSquareRoom, 0.1), PointCloudView(points_m), gaussian);
  ViewModel<PolygonView, models::GaussianRange> polygon(
      rasterize(kSquareRoom, 0.1), PolygonView(kSquareRoom, {.max_range_m = 2.0}), gaussian);
  const std::vector<RangeReading> readings{{{}, 0.55}};
  Particles one = particles_at({{0.5, 0.5, 0.0}, {0.2, 0.3, 0.0}});
  Particles other = one;
  cloud.observe(readings);
  polygon.observe(readings);
  cloud.update_weights(1.0F, {0, 2}, one);
  polygon.update_weights(1.0F, {0, 2}, other);
  EXPECT_NEAR(one.log_weight[0], other.log_weight[0], 1e-3);
  EXPECT_NEAR(one.log_weight[1], other.log_weight[1], 1e-3);
}

TEST(ViewModel, ImpossibleReadingsStayFinite) {
  ViewModel<PolygonView, models::GaussianRange> model(
      rasterize(kSquareRoom, 0.1),
      PolygonView(kSquareRoom, {.max_range_m = 2.0}),
      models::GaussianRange());
  model.observe(std::vector<RangeReading>(8, {{}, 2.5}));
  Particles particles = particles_at({{0.5, 0.5, 0.0}});
  model.update_weights(1.0F, {0, 1}, particles);
  EXPECT_TRUE(std::isfinite(particles.log_weight[0]));
}

TEST(ViewModel, LeavesOutWhatIsNotFinite) {
  ViewModel<PolygonView, models::GaussianRange> model(
      rasterize(kSquareRoom, 0.1), PolygonView(kSquareRoom), models::GaussianRange());
  const std::vector<RangeReading> broken{{{}, std::numeric_limits<double>::quiet_NaN()}};
  model.observe(broken);
  EXPECT_EQ(model.count(), 0U);
}

}  // namespace
}  // namespace echomap::localization

// SPDX-License-Identifier: MIT
#include "host/exploration/epuck_drive.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/segment.hpp"
#include "tests/host/exploration/infrared_ring.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exploration {
namespace {

using geometry::Pose2;
using geometry::Segment;

/// A field with a block in it, and a robot that does as it is told; its beams see 6 cm far what
/// they meet within 25 degrees of a right angle.
class Field {
 public:
  explicit Field(const InfraredFollowerParams& robot) : robot_(robot) {}

  pipeline::Snapshot seen() const {
    pipeline::Snapshot snapshot;
    snapshot.latest = tests::pose_at(time_s_, pose_);
    for (const Pose2& T_robot_sensor : robot_.T_robot_sensor) {
      snapshot.infrared.range_m.push_back(range_m(pose_ * T_robot_sensor));
    }
    return snapshot;
  }

  void carry_out(const Roll& roll) {
    const double half_rad = 0.5 * roll.turn_rad_per_s * roll.for_s;
    const double travelled_m = roll.forward_m_per_s * roll.for_s;
    pose_ =
        pose_ *
        Pose2(travelled_m * std::cos(half_rad), travelled_m * std::sin(half_rad), 2.0 * half_rad);
    time_s_ += roll.for_s;
    for (const Segment& wall : walls_) {
      push_out_of(wall);
    }
  }

 private:
  /// An edge that no beam sees stops the hull.
  void push_out_of(const Segment& wall) {
    const Eigen::Vector2d place_m = pose_.position_m();
    const Eigen::Vector2d away_m = place_m - geometry::nearest_point(wall, place_m);
    const double lacking_m = robot_.robot_radius_m - away_m.norm();
    if (lacking_m > 0.0) {
      const Eigen::Vector2d free_m = place_m + lacking_m * away_m.normalized();
      pose_ = {free_m.x(), free_m.y(), pose_.heading_rad()};
    }
  }

  std::optional<double> range_m(const Pose2& T_field_sensor) const {
    const Eigen::Vector2d ahead(std::cos(T_field_sensor.heading_rad()),
                                std::sin(T_field_sensor.heading_rad()));
    std::optional<double> nearest_m;
    double cosine = 0.0;
    for (const Segment& wall : walls_) {
      const auto hit_m = geometry::ray_distance_m(T_field_sensor.position_m(), ahead, wall);
      if (hit_m && (!nearest_m || *hit_m < *nearest_m)) {
        nearest_m = hit_m;
        cosine = std::abs(geometry::left_normal(wall).dot(ahead));
      }
    }
    const bool answers = nearest_m && *nearest_m <= 0.06 && cosine > std::cos(0.44);
    return answers ? nearest_m : std::nullopt;
  }

  InfraredFollowerParams robot_;
  std::vector<Segment> walls_{{{0.0, 0.0}, {0.8, 0.0}},
                              {{0.8, 0.0}, {0.8, 0.6}},
                              {{0.8, 0.6}, {0.0, 0.6}},
                              {{0.0, 0.6}, {0.0, 0.0}},
                              {{0.35, 0.2}, {0.35, 0.35}},
                              {{0.35, 0.35}, {0.5, 0.35}},
                              {{0.5, 0.35}, {0.5, 0.2}},
                              {{0.5, 0.2}, {0.35, 0.2}}};
  Pose2 pose_{0.1, 0.1, 0.05};
  double time_s_ = 0.0;
};

TEST(EpuckDrive, GoesRoundTheFieldAndItsBlockAndCoversWhatLiesBetween) {
  EpuckDriveParams params;
  params.follower = ring_params();
  EpuckDrive drive(params);
  Field field(params.follower);
  std::optional<FinishReason> reason;
  for (int tick = 0; tick < 20000 && !reason; ++tick) {
    const Motion motion = drive.next(field.seen(), MotionResult::kReached);
    if (const auto* finished = std::get_if<Finished>(&motion)) {
      reason = finished->reason;
    } else {
      field.carry_out(std::get<Roll>(motion));
    }
  }
  EXPECT_EQ(reason, FinishReason::kComplete);
  EXPECT_EQ(drive.ground().loops().size(), 2U);
  EXPECT_TRUE(drive.ground().knows_the_room());
  for (const Eigen::Vector2d& place_m : {Eigen::Vector2d(0.2, 0.3), Eigen::Vector2d(0.65, 0.45)}) {
    EXPECT_TRUE(drive.ground().is_covered(place_m)) << place_m.transpose();
  }
}

TEST(EpuckDrive, GivesUpAfterTooLong) {
  EpuckDriveParams params;
  params.follower = ring_params();
  params.max_s = 5.0;
  EpuckDrive drive(params);
  Field field(params.follower);
  EXPECT_TRUE(std::holds_alternative<Roll>(drive.next(field.seen(), {})));
  field.carry_out({0.0, 0.0, 6.0});
  const Motion motion = drive.next(field.seen(), {});
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kNowhereToGo);
}

TEST(EpuckDrive, RefusesParametersWithoutSense) {
  EpuckDriveParams params;
  EXPECT_THROW(EpuckDrive{params}, std::invalid_argument) << "no sensors";
  params.follower = ring_params();
  params.max_walls = 0;
  EXPECT_THROW(EpuckDrive{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration

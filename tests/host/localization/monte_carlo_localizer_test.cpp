// SPDX-License-Identifier: MIT
#include "host/localization/monte_carlo_localizer.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/localization/contact_model.hpp"
#include "host/localization/likelihood_field_model.hpp"
#include "host/localization/range_table_model.hpp"
#include "host/mapping/polygon_map.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/expect_pose_estimate.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;

/// 4.0 x 3.2 m without symmetry.
const mapping::RasterMap kRoom = tests::map_from(
    {"########################################", "#......................................#",
     "#......................................#", "#...........#####......................#",
     "#...........#####......................#", "#......................................#",
     "#......................................#", "#.............................#........#",
     "#.............................#........#", "#.............................#........#",
     "#.............................#........#", "#......................................#",
     "#....###...............................#", "#....###...............................#",
     "#....###...............................#", "#......................................#",
     "#......................................#", "#......................................#",
     "#....................###################", "#....................###################",
     "#......................................#", "#......................................#",
     "########################################"},
    0.1);

/// A robot with eight sonars whose odometry and ears are a little off.
class SonarRobot {
 public:
  explicit SonarRobot(std::uint32_t seed) : random_(seed) {
    std::uniform_real_distribution<double> any(0.0, 1.0);
    do {
      T_map_robot_ = {4.0 * any(random_), 2.3 * any(random_), 6.28 * any(random_)};
    } while (!is_clear(T_map_robot_.position_m()));
  }

  void drive() {
    const double turn_rad = 0.2 * normal_(random_);
    const Pose2 step(0.1, 0.0, turn_rad);
    if (is_clear((T_map_robot_ * step).position_m())) {
      go(step);
    } else {
      go({0.0, 0.0, 1.0});
    }
  }
  /// Without a word of the odometry.
  void be_carried_to(const Pose2& T_map_robot) { T_map_robot_ = T_map_robot; }

  std::vector<RangeReading> listen() {
    std::vector<RangeReading> readings;
    for (int i = 0; i < 8; ++i) {
      const Pose2 T_robot_sensor(0.0, 0.0, std::numbers::pi / 4.0 * i);
      readings.push_back({T_robot_sensor, echo(T_map_robot_ * T_robot_sensor)});
    }
    return readings;
  }

  const Pose2& T_odom_robot() const { return T_odom_robot_; }
  const Pose2& T_map_robot() const { return T_map_robot_; }

 private:
  void go(const Pose2& step) {
    T_map_robot_ = T_map_robot_ * step;
    T_odom_robot_ = T_odom_robot_ * Pose2(step.x_m() * (1.0 + 0.02 * normal_(random_)),
                                          0.0,
                                          step.heading_rad() * (1.0 + 0.02 * normal_(random_)) +
                                              0.005 * normal_(random_));
  }
  static bool is_wall(const Eigen::Vector2d& point_m) {
    return kRoom.state(kRoom.cell_at(point_m)) != mapping::CellState::kFree;
  }
  static bool is_clear(const Eigen::Vector2d& point_m) {
    for (double way_rad = 0.0; way_rad < 6.28; way_rad += 0.5) {
      if (is_wall(point_m + 0.12 * Eigen::Vector2d(std::cos(way_rad), std::sin(way_rad)))) {
        return false;
      }
    }
    return true;
  }
  /// The nearest wall in a cone of 25 degrees, in steps of a centimetre; 1 in 50 is not heard.
  std::optional<double> echo(const Pose2& T_map_sensor) {
    if (random_() % 50 == 0) {
      return std::nullopt;
    }
    for (double range_m = 0.0; range_m < 4.0; range_m += 0.01) {
      for (double off_rad = -0.218; off_rad <= 0.218; off_rad += 0.0218) {
        if (is_wall(T_map_sensor *
                    Eigen::Vector2d(range_m * std::cos(off_rad), range_m * std::sin(off_rad)))) {
          return std::max(0.02, range_m + 0.02 * normal_(random_));
        }
      }
    }
    return std::nullopt;
  }

  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  Pose2 T_map_robot_;
  Pose2 T_odom_robot_;
};

struct Filter {
  explicit Filter(const mapping::RasterMap& map,
                  std::uint32_t seed = 1,
                  const LocalizerParams& params = {})
      : model(RangeTable(map, {0.218, 4.0}), models::BeamModel(models::sonar_cone_returns())),
        localizer(model, params, std::mt19937(seed)) {}

  void start_at_truth(const SonarRobot& robot) {
    localizer.update(robot.T_odom_robot(), {});
    localizer.start_at(robot.T_map_robot(), 0.05, 0.05);
  }

  const PoseBelief& follow(SonarRobot& robot, int steps) {
    for (int i = 0; i < steps; ++i) {
      robot.drive();
      localizer.update(robot.T_odom_robot(), robot.listen());
    }
    return localizer.belief();
  }

  RangeTableModel model;
  MonteCarloLocalizer localizer;
};

bool is_at(const PoseBelief& belief, const Pose2& truth) {
  return tests::is_estimated_near(belief, truth, 0.15, geometry::radians(10.0));
}

TEST(MonteCarloLocalizer, FindsARobotThatMayBeAnywhere) {
  int found = 0;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SonarRobot robot(seed);
    Filter filter(kRoom, seed);
    const PoseBelief& belief = filter.follow(robot, 15);
    found += is_at(belief, robot.T_map_robot()) ? 1 : 0;
  }
  EXPECT_GE(found, 19);
}

TEST(MonteCarloLocalizer, NoticesAKidnappingAndFindsTheRobotAgain) {
  int noticed = 0;
  int found = 0;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SonarRobot robot(seed);
    Filter filter(kRoom, seed);
    filter.start_at_truth(robot);
    ASSERT_TRUE(is_at(filter.follow(robot, 10), robot.T_map_robot())) << seed;
    robot.be_carried_to(SonarRobot(seed + 1000).T_map_robot());
    bool is_noticed = false;
    for (int i = 0; i < 15; ++i) {
      is_noticed |= filter.follow(robot, 1).status != LocalizationStatus::kLocalized;
    }
    noticed += is_noticed ? 1 : 0;
    found += is_at(filter.localizer.belief(), robot.T_map_robot()) ? 1 : 0;
  }
  EXPECT_GE(noticed, 19);
  EXPECT_GE(found, 19);
}

TEST(MonteCarloLocalizer, RepeatsItselfByItsSeed) {
  std::vector<PoseBelief> beliefs;
  for (int i = 0; i < 2; ++i) {
    SonarRobot robot(5);
    Filter filter(kRoom, 9);
    beliefs.push_back(filter.follow(robot, 10));
  }
  ASSERT_EQ(beliefs[0].hypotheses.size(), beliefs[1].hypotheses.size());
  EXPECT_EQ(beliefs[0].hypotheses[0].T_map_robot.x_m(), beliefs[1].hypotheses[0].T_map_robot.x_m());
  EXPECT_EQ(beliefs[0].lost_probability, beliefs[1].lost_probability);
}

/// All that a filter of so many threads knows, of a robot that is found, carried off and found
/// again.
std::vector<double> story(int threads) {
  SonarRobot robot(5);
  LocalizerParams params;
  params.threads = threads;
  Filter filter(kRoom, 9, params);
  std::vector<double> told;
  for (int i = 0; i < 30; ++i) {
    if (i == 15) {
      robot.be_carried_to(SonarRobot(1005).T_map_robot());
    }
    const PoseBelief& belief = filter.follow(robot, 1);
    told.push_back(belief.lost_probability);
    for (const PoseHypothesis& hypothesis : belief.hypotheses) {
      told.push_back(hypothesis.T_map_robot.x_m());
      told.push_back(hypothesis.covariance.sum());
    }
    const Particles& particles = filter.localizer.particles();
    told.insert(told.end(), particles.x_m.begin(), particles.x_m.end());
    told.insert(told.end(), particles.log_weight.begin(), particles.log_weight.end());
  }
  return told;
}

TEST(MonteCarloLocalizer, ComesToTheSameBitsOnAnyNumberOfThreads) {
  const std::vector<double> alone = story(1);
  EXPECT_EQ(alone, story(2));
  EXPECT_EQ(alone, story(3));
}

mapping::RasterMap walls_only() {
  mapping::RasterMap map(20, 20, 0.05, {0.0, 0.0});
  map.set({3, 4}, mapping::CellState::kOccupied);
  return map;
}

TEST(MonteCarloLocalizer, IsNowhereWhereThereIsNoFloor) {
  const std::vector<std::pair<mapping::RasterMap, LocalizerOutcome>> maps{
      {mapping::RasterMap(1, 1, 0.05, {0.0, 0.0}), LocalizerOutcome::kUnknownMap},
      {mapping::RasterMap(20, 20, 0.05, {0.0, 0.0}), LocalizerOutcome::kUnknownMap},
      {walls_only(), LocalizerOutcome::kNoFloor}};
  for (const auto& [map, outcome] : maps) {
    Filter filter(map);
    SonarRobot robot(1);
    const PoseBelief& belief = filter.follow(robot, 3);
    EXPECT_EQ(belief.outcome, outcome);
    EXPECT_EQ(filter.localizer.start_at({}, 0.1, 0.1), outcome);
    EXPECT_TRUE(belief.hypotheses.empty());
    EXPECT_EQ(belief.lost_probability, 1.0);
    EXPECT_EQ(belief.status, LocalizationStatus::kRecovering);
  }
}

TEST(MonteCarloLocalizer, SaysWhatHasBecomeOfAnUpdate) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  SonarRobot robot(3);
  Filter filter(kRoom);
  MonteCarloLocalizer& localizer = filter.localizer;
  EXPECT_EQ(localizer.belief().outcome, LocalizerOutcome::kNoParticles);
  EXPECT_EQ(localizer.update({}, {}).outcome, LocalizerOutcome::kNoParticles);
  EXPECT_EQ(localizer.update({}, robot.listen()).outcome, LocalizerOutcome::kWeighed);
  EXPECT_EQ(localizer.update({}, {}).outcome, LocalizerOutcome::kMoved);
  EXPECT_EQ(localizer.update({}, std::vector<RangeReading>(8)).outcome, LocalizerOutcome::kSilent);
  std::vector<RangeReading> broken(4);
  broken[0].range_m = kNaN;
  broken[1].range_m = std::numeric_limits<double>::infinity();
  broken[2].range_m = -0.5;
  broken[3].T_robot_sensor = {kNaN, 0.0, 0.0};
  EXPECT_EQ(localizer.update({}, broken).outcome, LocalizerOutcome::kNoUsableReading);
  broken.push_back({{}, 1.0});
  EXPECT_EQ(localizer.update({}, broken).outcome, LocalizerOutcome::kWeighed);
}

TEST(MonteCarloLocalizer, ContactsWeighWithoutReadings) {
  ContactModel model(mapping::PolygonMap({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}}), 0.1);
  MonteCarloLocalizer localizer(model, {}, std::mt19937(1));
  EXPECT_EQ(localizer.update({}, {}).outcome, LocalizerOutcome::kWeighed);
  EXPECT_EQ(localizer.update({}, std::vector<RangeReading>(1)).outcome, LocalizerOutcome::kSilent);
}

TEST(MonteCarloLocalizer, ASilentLaserIsNotABrokenOne) {
  LikelihoodFieldModel model(kRoom);
  MonteCarloLocalizer localizer(model, {}, std::mt19937(1));
  const std::vector<RangeReading> silence(8);
  const std::vector<RangeReading> broken{{{}, -1.0}};
  const std::vector<RangeReading> heard{{{}, 1.0}};
  EXPECT_EQ(localizer.update({}, silence).outcome, LocalizerOutcome::kSilent);
  EXPECT_EQ(localizer.update({}, broken).outcome, LocalizerOutcome::kNoUsableReading);
  EXPECT_EQ(localizer.update({}, heard).outcome, LocalizerOutcome::kWeighed);
}

TEST(MonteCarloLocalizer, FindsARobotOnAThinFloor) {
  // One cell wide, beside the middle of each square of the lattice.
  const mapping::RasterMap passage =
      tests::map_from({"############", "############", "#..........#", "############"}, 0.05);
  Filter filter(passage);
  const std::vector<RangeReading> heard{{{}, 0.3}};
  const PoseBelief& belief = filter.localizer.update({}, heard);
  EXPECT_EQ(belief.outcome, LocalizerOutcome::kWeighed);
  EXPECT_FALSE(belief.hypotheses.empty());
}

TEST(MonteCarloLocalizer, RefusesPosesThatAreNoNumbers) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  SonarRobot robot(3);
  Filter filter(kRoom);
  filter.start_at_truth(robot);
  for (const Pose2& pose : {Pose2(kNaN, 0.0, 0.0),
                            Pose2(0.0, std::numeric_limits<double>::infinity(), 0.0),
                            Pose2(0.0, 0.0, kNaN)}) {
    EXPECT_EQ(filter.localizer.update(pose, robot.listen()).outcome, LocalizerOutcome::kNotFinite);
    EXPECT_EQ(filter.localizer.start_at(pose, 0.1, 0.1), LocalizerOutcome::kNotFinite);
  }
  EXPECT_EQ(filter.localizer.start_at({}, kNaN, 0.1), LocalizerOutcome::kNotFinite);
  EXPECT_TRUE(is_at(filter.follow(robot, 3), robot.T_map_robot()));
}

TEST(MonteCarloLocalizer, LooksEverywhereForARobotThatWasOffTheFloor) {
  SonarRobot robot(3);
  Filter filter(kRoom);
  filter.localizer.update(robot.T_odom_robot(), {});
  EXPECT_EQ(filter.localizer.start_at({90.0, -70.0, 0.0}, 0.1, 0.1),
            LocalizerOutcome::kOffTheFloor);
  EXPECT_TRUE(filter.localizer.belief().hypotheses.empty());
  filter.start_at_truth(robot);
  // Odometry that is wrong by far takes it out of the map.
  const Pose2 T_odom_far = robot.T_odom_robot() * Pose2(40.0, 0.0, 0.0);
  const PoseBelief& belief = filter.localizer.update(T_odom_far, robot.listen());
  EXPECT_EQ(belief.outcome, LocalizerOutcome::kOffTheFloor);
  EXPECT_EQ(belief.status, LocalizationStatus::kLost);
  EXPECT_FALSE(belief.hypotheses.empty());
}

TEST(MonteCarloLocalizer, IsNoLongerLostWhereItIsPlacedAnew) {
  SonarRobot robot(3);
  Filter filter(kRoom);
  const auto lose = [&] {
    filter.start_at_truth(robot);
    const Pose2 T_odom_far = robot.T_odom_robot() * Pose2(40.0, 0.0, 0.0);
    return filter.localizer.update(T_odom_far, robot.listen()).status;
  };
  ASSERT_EQ(lose(), LocalizationStatus::kLost);
  filter.localizer.start_at(robot.T_map_robot(), 0.05, 0.05);
  EXPECT_EQ(filter.localizer.belief().status, LocalizationStatus::kLocalized);
  ASSERT_EQ(lose(), LocalizationStatus::kLost);
  filter.localizer.start_anywhere();
  EXPECT_EQ(filter.localizer.belief().status, LocalizationStatus::kRecovering);
}

TEST(MonteCarloLocalizer, CarriesItsBeliefAlongBetweenReadings) {
  SonarRobot robot(3);
  Filter filter(kRoom);
  filter.start_at_truth(robot);
  filter.follow(robot, 5);
  const Pose2 before = filter.localizer.belief().hypotheses.front().T_map_robot;
  const std::vector<float> particles = filter.localizer.particles().x_m;
  const Pose2 step(0.04, 0.0, 0.05);
  const PoseBelief& belief = filter.localizer.update(robot.T_odom_robot() * step, {});
  EXPECT_EQ(filter.localizer.particles().x_m, particles);
  const Pose2 off = (before * step).inverse() * belief.hypotheses.front().T_map_robot;
  EXPECT_NEAR(off.position_m().norm() + std::abs(off.heading_rad()), 0.0, 1e-9);
}

/// How far its hypothesis is spread after 1.05 m ahead that the odometry tells in so many parts.
double std_after_a_drive(int parts) {
  SonarRobot robot(3);
  Filter filter(kRoom);
  filter.localizer.update({}, {});
  filter.localizer.start_at({1.0, 1.0, 0.0}, 0.02, 0.02);
  for (int i = 1; i <= parts; ++i) {
    filter.localizer.update({1.05 * i / parts, 0.0, 0.0}, {});
  }
  return std::sqrt(filter.localizer.belief().hypotheses.front().covariance(0, 0));
}

TEST(MonteCarloLocalizer, IsAsUnsureHoweverOftenTheOdometrySpeaks) {
  EXPECT_NEAR(std_after_a_drive(1000), std_after_a_drive(10), 0.002);
}

TEST(MonteCarloLocalizer, KeepsWhatItKnowsWhenReadingsAreNone) {
  SonarRobot robot(3);
  Filter filter(kRoom);
  filter.start_at_truth(robot);
  const std::vector<RangeReading> broken{{{}, std::numeric_limits<double>::quiet_NaN()}};
  for (int i = 0; i < 5; ++i) {
    robot.drive();
    filter.localizer.update(robot.T_odom_robot(), {});
    filter.localizer.update(robot.T_odom_robot(), broken);
  }
  EXPECT_TRUE(is_at(filter.localizer.belief(), robot.T_map_robot()));
}

TEST(MonteCarloLocalizer, StaysSoberWhenNothingIsHeard) {
  SonarRobot robot(3);
  Filter filter(kRoom);
  const std::vector<RangeReading> silence(8);
  for (int i = 0; i < 30; ++i) {
    filter.localizer.update(robot.T_odom_robot(), silence);
  }
  EXPECT_NE(filter.localizer.belief().status, LocalizationStatus::kLocalized);
  for (const PoseHypothesis& hypothesis : filter.localizer.belief().hypotheses) {
    ASSERT_TRUE(hypothesis.covariance.allFinite());
  }
}

TEST(MonteCarloLocalizer, RefusesSettingsWithoutSense) {
  RangeTableModel model(RangeTable(kRoom, {0.2, 4.0}),
                        models::BeamModel(models::sonar_cone_returns()));
  const auto refuses = [&](auto&& set) {
    LocalizerParams params;
    set(params);
    EXPECT_THROW(MonteCarloLocalizer(model, params, std::mt19937(1)), std::invalid_argument);
  };
  refuses([](LocalizerParams& params) { params.filter.min_particles = 0; });
  refuses([](LocalizerParams& params) {
    params.filter.max_particles = params.filter.min_particles - 1;
  });
  refuses([](LocalizerParams& params) { params.filter.likelihood_exponent = 0.0; });
  refuses([](LocalizerParams& params) { params.lattice_m = 0.0; });
  refuses([](LocalizerParams& params) { params.step_m = 0.0; });
  refuses([](LocalizerParams& params) { params.threads = 0; });
  refuses([](LocalizerParams& params) { params.loss.kidnap_chance = 1.0; });
  refuses([](LocalizerParams& params) { params.hypotheses.bin_m = 0.0; });
  refuses([](LocalizerParams& params) { params.hypotheses.bin_rad = 0.0; });
  refuses([](LocalizerParams& params) { params.hypotheses.bin_rad = 7.0; });
  refuses([](LocalizerParams& params) { params.lost_above = -0.1; });
  refuses([](LocalizerParams& params) { params.localized_below = 1.1; });
  refuses([](LocalizerParams& params) { params.localized_stddev_m = 0.0; });
}

}  // namespace
}  // namespace echomap::localization

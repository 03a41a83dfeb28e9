// SPDX-License-Identifier: MIT
#include "host/localization/localizer_preset.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "host/localization/combined_model.hpp"
#include "host/localization/contact_model.hpp"
#include "host/localization/correlation_model.hpp"
#include "host/localization/likelihood_field_model.hpp"
#include "host/localization/point_cloud_view.hpp"
#include "host/localization/polygon_view.hpp"
#include "host/localization/range_table_model.hpp"
#include "host/localization/view_model.hpp"
#include "host/mapping/polygon_map.hpp"
#include "host/models/gaussian_range.hpp"
#include "host/models/infrared_range.hpp"

namespace echomap::localization {

namespace {

/// What the papers' filters have in common: a number of particles that stays, weights as they are,
/// no noise but that of the motion, no suspicion, and a start anywhere.
LocalizerParams plain_params(std::size_t particles, const LocalizedRobot& robot) {
  LocalizerParams params;
  params.filter.min_particles = particles;
  params.filter.max_particles = particles;
  params.filter.likelihood_exponent = 1.0;
  params.filter.max_independent = std::numeric_limits<double>::infinity();
  params.filter.resampling_share = 1.0;
  params.filter.spread_m = 0.0;
  params.filter.spread_rad = 0.0;
  params.watches_for_loss = false;
  params.global_start = GlobalStart::kScattered;
  // Places of a robot that sees no farther than 6 cm are told apart in a field of 80.
  if (robot.by != LocalizedBy::kContacts && robot.max_range_m > 0.0) {
    params.hypotheses.bin_m = std::min(params.hypotheses.bin_m, robot.max_range_m);
  }
  return params;
}

/// Singh and Bedi 2013, sections 4.3 to 4.5 and Algorithms 1 and 2.
LocalizerParams nxt_params(const LocalizedRobot& robot) {
  LocalizerParams params = plain_params(250, robot);
  params.motion = models::TurnForwardMotion();
  params.filter.scheme = ResamplingScheme::kWheel;
  return params;
}

/// Mukherjee et al., section V; the number of particles is ours, as the paper gives none.
LocalizerParams create_params(const LocalizedRobot& robot) {
  LocalizerParams params = plain_params(1000, robot);
  params.motion = models::LinearOdometryMotion();
  params.filter.motion_noise = NoiseShape::kUniformSum;
  params.filter.scheme = ResamplingScheme::kWheel;
  return params;
}

/// Mahmood and Ridao 2017, sections 3.3 and 4.1: resampled when fewer than half of the particles
/// count. The paper has no numbers for the motion; ours are 5 % of turns and drives.
LocalizerParams epuck_params(const LocalizedRobot& robot) {
  LocalizerParams params = plain_params(1000, robot);
  params.motion = models::OdometryMotion({.alpha1 = 0.0025,
                                          .alpha2_rad2_per_m2 = 0.0025,
                                          .alpha3 = 0.0025,
                                          .alpha4_m2_per_rad2 = 1e-4,
                                          .side_slip = 4e-4});
  params.filter.scheme = ResamplingScheme::kSystematic;
  params.filter.resampling_share = 0.5;
  return params;
}

/// Of a sensor whose silence is part of its readings.
LocalizerParams without_loss_monitor(LocalizerParams params) {
  params.watches_for_loss = false;
  return params;
}

/// Of the walls in the map of a robot that followed them, metres; as ContactParams has it.
constexpr double kFollowedWallStddevM = 0.02;

/// Ours, for a ring of infra-red sensors: lengths are in proportion to its reach. The correlation
/// of a whole round counts as one reading.
LocalizerParams infrared_params(const LocalizedRobot& robot) {
  LocalizerParams params = without_loss_monitor({});
  params.filter.min_particles = 3000;
  params.filter.likelihood_exponent = 1.0;
  params.filter.spread_m = 0.05 * robot.max_range_m;
  params.filter.spread_rad = 0.02;
  params.lattice_m = robot.max_range_m / 3.0;
  params.localized_stddev_m = robot.max_range_m;
  params.step_m = 0.5 * robot.max_range_m;
  params.hypotheses.bin_m = robot.max_range_m;
  return params;
}

/// A sonar's reading ends at the first thing in its cone.
std::unique_ptr<ObservationModel> cone_model(const mapping::RasterMap& map,
                                             const LocalizedRobot& robot,
                                             models::BeamModelParams returns,
                                             bool ends_with_known_floor) {
  returns.max_range_m = robot.max_range_m;
  return std::make_unique<RangeTableModel>(
      RangeTable(map, {robot.beam_half_angle_rad, robot.max_range_m, ends_with_known_floor}),
      models::BeamModel(returns));
}

/// The walls around the largest floor, as straight as the map's cells allow.
mapping::PolygonMap outline_of_floor(const mapping::RasterMap& map) {
  mapping::PolygonMapParams params;
  params.tolerance_m = 1.5 * map.resolution_m();
  params.min_hole_m2 = 8.0 * map.resolution_m() * map.resolution_m();
  const auto outline = mapping::polygon_from_raster(map, params);
  if (!outline) {
    throw std::invalid_argument("localizer preset: the map has no floor with an outline");
  }
  return *outline;
}

std::unique_ptr<ObservationModel> contact_model(const mapping::PolygonMap& outline,
                                                const LocalizedRobot& robot) {
  return std::make_unique<ContactModel>(outline, robot.body_radius_m);
}

std::unique_ptr<ObservationModel> wall_sensor_model(const mapping::RasterMap& map,
                                                    const mapping::PolygonMap& outline,
                                                    const LocalizedRobot& robot) {
  PolygonViewParams view;
  view.max_range_m = robot.max_range_m;
  models::InfraredRangeParams range;
  range.max_range_m = robot.max_range_m;
  range.near_stddev_m = kFollowedWallStddevM;
  return std::make_unique<ViewModel<PolygonView, models::InfraredRange>>(
      map, PolygonView(outline, view), models::InfraredRange(range));
}

/// Of a robot with bumpers, and with a wall sensor where it has one.
std::unique_ptr<ObservationModel> touch_model(const mapping::RasterMap& map,
                                              const LocalizedRobot& robot) {
  const mapping::PolygonMap outline = outline_of_floor(map);
  if (robot.max_range_m == 0.0) {
    return contact_model(outline, robot);
  }
  std::vector<std::unique_ptr<ObservationModel>> models;
  models.push_back(contact_model(outline, robot));
  models.push_back(wall_sensor_model(map, outline, robot));
  return std::make_unique<CombinedModel>(std::move(models));
}

/// The correlation of a round with the grid (Mahmood and Ridao 2017, section 3.3).
std::unique_ptr<ObservationModel> grid_model(const mapping::RasterMap& map,
                                             const LocalizedRobot& robot) {
  CorrelationModelParams params;
  // In a map of millimetres a ring's round needs no more cells than it has precision.
  const double precision_m = robot.by == LocalizedBy::kInfrared ? 0.1 * robot.max_range_m : 0.0;
  params.cell_m = std::max(map.resolution_m(), precision_m);
  params.sector.thickness_m = 2.0 * params.cell_m;
  params.sector.max_range_m = robot.max_range_m;
  params.sector.beam_width_rad = std::max(2.0 * robot.beam_half_angle_rad, 0.0175);
  return std::make_unique<CorrelationModel>(map, params);
}

std::unique_ptr<ObservationModel> default_model(const mapping::RasterMap& map,
                                                const LocalizedRobot& robot) {
  switch (robot.by) {
    case LocalizedBy::kLaser:
      return std::make_unique<LikelihoodFieldModel>(map);
    case LocalizedBy::kInfrared:
      return grid_model(map, robot);
    case LocalizedBy::kContacts:
      return touch_model(map, robot);
    case LocalizedBy::kSonar:
      break;
  }
  return cone_model(map, robot, models::sonar_cone_returns(), false);
}

LocalizerParams default_params(const LocalizedRobot& robot) {
  switch (robot.by) {
    case LocalizedBy::kInfrared:
      return infrared_params(robot);
    case LocalizedBy::kContacts:
      return without_loss_monitor({});
    case LocalizedBy::kSonar:
    case LocalizedBy::kLaser:
      break;
  }
  return {};
}

std::unique_ptr<ObservationModel> nxt_model(const mapping::RasterMap& map,
                                            const LocalizedRobot& robot) {
  PointCloudViewParams cloud;
  // So that no beam slips through a wall of cells, not even between two that meet in a corner.
  cloud.half_width_m = 0.5 * std::numbers::sqrt2 * map.resolution_m();
  cloud.max_range_m = robot.max_range_m;
  models::GaussianRangeParams range;
  range.max_range_m = robot.max_range_m;
  return std::make_unique<ViewModel<PointCloudView, models::GaussianRange>>(
      map, PointCloudView(occupied_points(map), cloud), models::GaussianRange(range));
}

}  // namespace

LocalizerParams localizer_params(LocalizerPreset preset, const LocalizedRobot& robot) {
  switch (preset) {
    case LocalizerPreset::kNxt:
      return nxt_params(robot);
    case LocalizerPreset::kCreate:
      return create_params(robot);
    case LocalizerPreset::kEpuck:
      return epuck_params(robot);
    case LocalizerPreset::kDefault:
      break;
  }
  return default_params(robot);
}

std::unique_ptr<ObservationModel> observation_model(LocalizerPreset preset,
                                                    const mapping::RasterMap& map,
                                                    const LocalizedRobot& robot) {
  switch (preset) {
    case LocalizerPreset::kNxt:
      return nxt_model(map, robot);
    case LocalizerPreset::kCreate:
      return contact_model(outline_of_floor(map), robot);
    case LocalizerPreset::kEpuck:
      return grid_model(map, robot);
    case LocalizerPreset::kDefault:
      break;
  }
  return default_model(map, robot);
}

std::unique_ptr<ObservationModel> own_map_model(const mapping::RasterMap& map,
                                                const LocalizedRobot& robot) {
  return cone_model(map, robot, models::sonar_cone_returns_in_own_map(), true);
}

}  // namespace echomap::localization

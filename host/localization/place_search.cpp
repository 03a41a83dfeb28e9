// SPDX-License-Identifier: MIT
#include "host/localization/place_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <numeric>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/localization/floor_lattice.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;

/// A sector that nothing explains says no more than that.
constexpr double kMinLog = -4.0;
/// Poses of the lattice that differ by less lead to one refined pose.
constexpr double kNeighboursM = 0.35;
constexpr double kNeighboursRad = 0.35;
/// A robot that has moved by less is on the same spot.
constexpr double kSameSpotM = 0.1;
/// Of fewer sectors the deviation says nothing.
constexpr std::size_t kMinSectors = 4;
constexpr double kMaxDeviations = 8.0;

bool are_near(const Pose2& one, const Pose2& other, double metres, double radians) {
  return (one.position_m() - other.position_m()).norm() <= metres &&
         std::abs(geometry::angle_between(one.heading_rad(), other.heading_rad())) <= radians;
}

/// Of a standard normal variable: the probability that it is above `z`.
double tail(double z) { return 0.5 * std::erfc(z / std::numbers::sqrt2); }

/// By how many of its standard deviations the mean of the differences is above 0.
double vuong(std::span<const double> better, std::span<const double> worse) {
  // Two places that look the same differ by next to nothing, but everywhere.
  constexpr double kMinDeviation = 0.05;
  const auto count = static_cast<double>(better.size());
  const double mean =
      std::inner_product(
          better.begin(), better.end(), worse.begin(), 0.0, std::plus<>(), std::minus<>()) /
      count;
  double squares = 0.0;
  for (std::size_t i = 0; i < better.size(); ++i) {
    const double off = better[i] - worse[i] - mean;
    squares += off * off;
  }
  const double deviation = std::sqrt(squares / std::max(1.0, count - 1.0)) + kMinDeviation;
  return mean / (deviation / std::sqrt(count));
}

/// Poses around one, half a step and a whole one to each side in place and heading.
Particles around(const Pose2& middle, double step_m, double step_rad) {
  constexpr int kSide = 2;
  constexpr std::size_t kAcross = 2 * kSide + 1;
  Particles particles;
  particles.resize(kAcross * kAcross * kAcross);
  std::size_t i = 0;
  for (int x = -kSide; x <= kSide; ++x) {
    for (int y = -kSide; y <= kSide; ++y) {
      for (int turn = -kSide; turn <= kSide; ++turn) {
        particles.set_pose(i++,
                           {middle.x_m() + 0.5 * step_m * x,
                            middle.y_m() + 0.5 * step_m * y,
                            geometry::wrap_angle(middle.heading_rad() + 0.5 * step_rad * turn)});
      }
    }
  }
  return particles;
}

std::size_t heaviest(const Particles& particles) {
  return static_cast<std::size_t>(
      std::max_element(particles.log_weight.begin(), particles.log_weight.end()) -
      particles.log_weight.begin());
}

}  // namespace

PlaceSearch::PlaceSearch(ObservationModel& model, const PlaceSearchParams& params)
    : model_(model), params_(params) {
  geometry::ParameterValidator("place search")
      .at_least("max_scans", params.max_scans, 1)
      .positive("lattice_m", params.lattice_m)
      .positive("lattice_rad", params.lattice_rad)
      .at_least("candidates", params.candidates, 1)
      .positive("same_place_m", params.same_place_m)
      .positive("same_place_rad", params.same_place_rad)
      .at_least("sectors", params.sectors, 1)
      .positive("independent_share", params.independent_share)
      .at_most("independent_share", params.independent_share, 1.0);
}

void PlaceSearch::add(const Pose2& T_odom_robot, std::span<const RangeReading> readings) {
  if (!scans_.empty() &&
      (scans_.back().T_odom_robot.position_m() - T_odom_robot.position_m()).norm() < kSameSpotM) {
    scans_.pop_back();
  }
  scans_.push_back({T_odom_robot, {readings.begin(), readings.end()}});
  keep_newest(params_.max_scans);
}

void PlaceSearch::keep_newest(std::size_t scans) {
  while (scans_.size() > scans) {
    scans_.pop_front();
  }
}

bool PlaceSearch::is_same_place(const Pose2& one, const Pose2& other) const {
  return are_near(one, other, params_.same_place_m, params_.same_place_rad);
}

std::vector<FoundPlace> PlaceSearch::search(std::size_t newest,
                                            const std::optional<Pose2>& T_map_believed) {
  model_.observe(joined(newest));
  if (model_.count() == 0) {
    return {};
  }
  std::vector<FoundPlace> places;
  for (const Pose2& T_map_robot : likeliest_of_lattice()) {
    places.push_back(refined(T_map_robot));
  }
  if (T_map_believed) {
    places.push_back(refined(*T_map_believed));
    places.back().is_believed = true;
  }
  places = each_once(std::move(places));
  compare(sectors_of(newest), places);
  return places;
}

std::vector<RangeReading> PlaceSearch::joined(std::size_t newest) const {
  std::vector<RangeReading> readings;
  for (auto scan = scans_.rbegin(); scan != scans_.rend() && newest > 0; ++scan, --newest) {
    const Pose2 T_now_then = scans_.back().T_odom_robot.inverse() * scan->T_odom_robot;
    for (const RangeReading& reading : scan->readings) {
      readings.push_back({T_now_then * reading.T_robot_sensor, reading.range_m});
    }
  }
  return readings;
}

std::vector<PlaceSearch::Sector> PlaceSearch::sectors_of(std::size_t newest) const {
  std::vector<Sector> sectors;
  for (auto scan = scans_.rbegin(); scan != scans_.rend() && newest > 0; ++scan, --newest) {
    const Pose2 T_now_then = scans_.back().T_odom_robot.inverse() * scan->T_odom_robot;
    std::vector<Sector> of_scan(params_.sectors);
    for (const RangeReading& reading : scan->readings) {
      const Pose2 T_robot_sensor = T_now_then * reading.T_robot_sensor;
      const double turns =
          geometry::wrap_angle(T_robot_sensor.heading_rad()) / (2.0 * std::numbers::pi) + 0.5;
      const auto number =
          static_cast<std::size_t>(std::max(turns, 0.0) * static_cast<double>(params_.sectors));
      of_scan[std::min(number, params_.sectors - 1)].push_back({T_robot_sensor, reading.range_m});
    }
    std::copy_if(of_scan.begin(), of_scan.end(), std::back_inserter(sectors), [](const auto& some) {
      return some.size() > 1;
    });
  }
  return sectors;
}

void PlaceSearch::weigh(Particles& particles) {
  model_.make_ready(particles, Workers());
  std::fill(particles.log_weight.begin(), particles.log_weight.end(), 0.0F);
  model_.update_weights(1.0F, {0, particles.size()}, particles);
}

std::vector<Pose2> PlaceSearch::likeliest_of_lattice() {
  if (lattice_.size() == 0) {
    lattice_ = floor_lattice(model_.map(), params_.lattice_m, params_.lattice_rad);
  }
  weigh(lattice_);
  std::vector<std::size_t> order(lattice_.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
    return lattice_.log_weight[one] > lattice_.log_weight[other];
  });
  std::vector<Pose2> likeliest;
  for (const std::size_t i : order) {
    const Pose2 T_map_robot = lattice_.pose(i);
    const bool is_new = std::none_of(likeliest.begin(), likeliest.end(), [&](const Pose2& other) {
      return are_near(T_map_robot, other, kNeighboursM, kNeighboursRad);
    });
    if (is_new) {
      likeliest.push_back(T_map_robot);
    }
    if (likeliest.size() == params_.candidates) {
      break;
    }
  }
  return likeliest;
}

FoundPlace PlaceSearch::refined(Pose2 T_map_robot) {
  constexpr int kRounds = 4;
  double step_m = 0.5 * params_.lattice_m;
  double step_rad = 0.5 * params_.lattice_rad;
  double log_weight = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    Particles particles = around(T_map_robot, step_m, step_rad);
    weigh(particles);
    const std::size_t best = heaviest(particles);
    T_map_robot = particles.pose(best);
    log_weight = static_cast<double>(particles.log_weight[best]);
    step_m *= 0.5;
    step_rad *= 0.5;
  }
  return {T_map_robot, log_weight / static_cast<double>(model_.count()), 1.0, false};
}

std::vector<FoundPlace> PlaceSearch::each_once(std::vector<FoundPlace> places) const {
  std::stable_sort(places.begin(), places.end(), [](const auto& one, const auto& other) {
    return one.log_likelihood > other.log_likelihood;
  });
  std::vector<FoundPlace> once;
  for (const FoundPlace& place : places) {
    const auto same = std::find_if(once.begin(), once.end(), [&](const FoundPlace& other) {
      return is_same_place(place.T_map_robot, other.T_map_robot);
    });
    if (same == once.end()) {
      once.push_back(place);
    } else {
      same->is_believed = same->is_believed || place.is_believed;
    }
  }
  return once;
}

void PlaceSearch::compare(std::span<const Sector> sectors, std::vector<FoundPlace>& places) {
  Particles particles;
  particles.resize(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    particles.set_pose(i, places[i].T_map_robot);
  }
  std::vector<std::vector<double>> log_likelihoods(places.size());
  for (const Sector& sector : sectors) {
    model_.observe(sector);
    weigh(particles);
    const auto readings = static_cast<double>(std::max<std::size_t>(1, model_.count()));
    for (std::size_t i = 0; i < places.size(); ++i) {
      log_likelihoods[i].push_back(
          std::max(kMinLog, static_cast<double>(particles.log_weight[i]) / readings));
    }
  }
  if (sectors.size() < kMinSectors) {
    return;
  }
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double z = std::clamp(
        std::sqrt(params_.independent_share) * vuong(log_likelihoods[0], log_likelihoods[i]),
        -kMaxDeviations,
        kMaxDeviations);
    places[i].odds = tail(z) / tail(-z);
  }
}

}  // namespace echomap::localization

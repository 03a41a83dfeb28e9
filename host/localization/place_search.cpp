// SPDX-License-Identifier: MIT
#include "host/localization/place_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/localization/floor_lattice.hpp"
#include "host/localization/path_alignment.hpp"
#include "host/localization/pose_lattice.hpp"
#include "host/localization/vuong_test.hpp"

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

bool are_near(const Pose2& one, const Pose2& other, double metres, double radians) {
  return (one.position_m() - other.position_m()).norm() <= metres &&
         std::abs(geometry::angle_between(one.heading_rad(), other.heading_rad())) <= radians;
}

std::size_t heaviest(const Particles& particles) {
  return static_cast<std::size_t>(
      std::max_element(particles.log_weight.begin(), particles.log_weight.end()) -
      particles.log_weight.begin());
}

double mean_of(std::span<const double> numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0) /
         static_cast<double>(std::max<std::size_t>(1, numbers.size()));
}

/// Of each path, sector by sector of each scan: the mean log-likelihood of a reading.
std::vector<std::vector<double>> sector_log_likelihoods(ObservationModel& model,
                                                        std::span<const StopScan> scans,
                                                        const std::vector<ScanPath>& paths,
                                                        std::size_t sectors) {
  std::vector<std::vector<double>> log_likelihoods(paths.size());
  Particles particles;
  particles.resize(paths.size());
  for (std::size_t scan = 0; scan < scans.size(); ++scan) {
    for (std::size_t path = 0; path < paths.size(); ++path) {
      particles.set_pose(path, paths[path][scan]);
    }
    for (const auto& sector : sectors_of(scans[scan], sectors)) {
      model.observe(sector);
      set_log_likelihoods(model, particles);
      const auto readings = static_cast<double>(std::max<std::size_t>(1, model.count()));
      for (std::size_t path = 0; path < paths.size(); ++path) {
        log_likelihoods[path].push_back(
            std::max(kMinLog, static_cast<double>(particles.log_weight[path]) / readings));
      }
    }
  }
  return log_likelihoods;
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

void PlaceSearch::add(StopScan scan) {
  if (!scans_.empty() &&
      (scans_.front().T_odom_robot.position_m() - scan.T_odom_robot.position_m()).norm() <
          kSameSpotM) {
    scans_.erase(scans_.begin());
  }
  scans_.insert(scans_.begin(), std::move(scan));
  keep_newest(params_.max_scans);
}

void PlaceSearch::keep_newest(std::size_t scans) {
  if (scans < scans_.size()) {
    scans_.resize(scans);
    if (!scans_.empty()) {
      scans_.back().on_the_way.clear();
    }
  }
}

bool PlaceSearch::is_same_place(const Pose2& one, const Pose2& other) const {
  return are_near(one, other, params_.same_place_m, params_.same_place_rad);
}

std::vector<FoundPlace> PlaceSearch::search(std::size_t newest,
                                            const std::optional<Pose2>& T_map_believed) {
  const std::span<const StopScan> scans(scans_.data(), std::min(newest, scans_.size()));
  model_.observe(joined(scans));
  if (model_.count() == 0) {
    return {};
  }
  std::vector<Pose2> starts = likeliest_of_lattice();
  if (T_map_believed) {
    starts.push_back(*T_map_believed);
  }
  std::vector<ScanPath> paths;
  for (const Pose2& T_map_robot : starts) {
    paths.push_back(path_by_odometry(scans, refined(T_map_robot)));
  }
  align_paths(scans, model_, paths);
  const auto log_likelihoods = sector_log_likelihoods(model_, scans, paths, params_.sectors);
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    candidates.push_back({{paths[i].front(),
                           mean_of(log_likelihoods[i]),
                           1.0,
                           T_map_believed && i + 1 == paths.size()},
                          log_likelihoods[i]});
  }
  return compared(each_once(std::move(candidates)));
}

std::vector<Pose2> PlaceSearch::likeliest_of_lattice() {
  if (lattice_.size() == 0) {
    lattice_ = floor_lattice(model_.map(), params_.lattice_m, params_.lattice_rad);
  }
  set_log_likelihoods(model_, lattice_);
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

Pose2 PlaceSearch::refined(Pose2 T_map_robot) {
  constexpr int kRounds = 4;
  double step_m = 0.5 * params_.lattice_m;
  double step_rad = 0.5 * params_.lattice_rad;
  for (int round = 0; round < kRounds; ++round) {
    Particles particles = poses_around(T_map_robot, step_m, step_rad);
    set_log_likelihoods(model_, particles);
    T_map_robot = particles.pose(heaviest(particles));
    step_m *= 0.5;
    step_rad *= 0.5;
  }
  return T_map_robot;
}

std::vector<PlaceSearch::Candidate> PlaceSearch::each_once(
    std::vector<Candidate> candidates) const {
  std::stable_sort(
      candidates.begin(), candidates.end(), [](const Candidate& one, const Candidate& other) {
        return one.place.log_likelihood > other.place.log_likelihood;
      });
  std::vector<Candidate> once;
  for (Candidate& candidate : candidates) {
    const auto same = std::find_if(once.begin(), once.end(), [&](const Candidate& other) {
      return is_same_place(candidate.place.T_map_robot, other.place.T_map_robot);
    });
    if (same == once.end()) {
      once.push_back(std::move(candidate));
    } else {
      same->place.is_believed = same->place.is_believed || candidate.place.is_believed;
    }
  }
  return once;
}

std::vector<FoundPlace> PlaceSearch::compared(const std::vector<Candidate>& candidates) const {
  std::vector<FoundPlace> places;
  for (const Candidate& candidate : candidates) {
    const std::vector<double>& best = candidates.front().sectors;
    places.push_back(candidate.place);
    if (places.size() > 1 && best.size() >= kMinSectors) {
      places.back().odds = odds_of_worse(std::sqrt(params_.independent_share) *
                                         vuong_statistic(best, candidate.sectors));
    }
  }
  return places;
}

}  // namespace echomap::localization

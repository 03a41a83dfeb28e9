// SPDX-License-Identifier: MIT
#include "host/localization/place_check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/square.hpp"
#include "host/localization/usable_reading.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;

/// A filter that is this near to a place, and so narrow, follows it.
constexpr double kFollowedM = 0.2;
constexpr double kFollowedRad = 0.2;
constexpr double kFollowedStddevM = 0.25;

/// As hypotheses: probabilities in place of odds.
std::vector<PoseHypothesis> hypotheses_of(const std::vector<FoundPlace>& places,
                                          double least_probability) {
  double all = 0.0;
  for (const FoundPlace& place : places) {
    all += place.odds;
  }
  std::vector<PoseHypothesis> hypotheses;
  for (const FoundPlace& place : places) {
    if (place.odds >= least_probability * all) {
      Eigen::Matrix3d covariance = geometry::square(kFoundStddevM) * Eigen::Matrix3d::Identity();
      covariance(2, 2) = geometry::square(kFoundStddevRad);
      hypotheses.push_back({place.T_map_robot, covariance, place.odds / all});
    }
  }
  std::stable_sort(hypotheses.begin(), hypotheses.end(), [](const auto& one, const auto& other) {
    return one.probability > other.probability;
  });
  return hypotheses;
}

/// Among places of which one is believed.
double probability_of_believed(const std::vector<FoundPlace>& places) {
  double all = 0.0;
  double believed = 0.0;
  for (const FoundPlace& place : places) {
    all += place.odds;
    believed += place.is_believed ? place.odds : 0.0;
  }
  return all > 0.0 ? believed / all : 1.0;
}

/// Whether a filter with that belief follows the place.
bool is_followed(const PoseHypothesis& place, const PoseBelief& believed) {
  if (believed.hypotheses.empty()) {
    return false;
  }
  const PoseHypothesis& first = believed.hypotheses.front();
  const Pose2 off = first.T_map_robot.inverse() * place.T_map_robot;
  return off.position_m().norm() < kFollowedM && std::abs(off.heading_rad()) < kFollowedRad &&
         std::sqrt(first.covariance.topLeftCorner<2, 2>().trace()) < kFollowedStddevM;
}

}  // namespace

PlaceCheck::PlaceCheck(ObservationModel& model, const PlaceCheckParams& params)
    : params_(params), search_(model, params.search) {
  geometry::ParameterValidator("place check")
      .within("claimed_from", params.claimed_from, 0.0, 1.0)
      .within("lost_below", params.lost_below, 0.0, 1.0)
      .within("elsewhere_chance", params.elsewhere_chance, 0.0, 1.0)
      .within("told_from", params.told_from, 0.0, 1.0)
      .positive("departure_m", params.departure_m)
      .positive("departure_rad", params.departure_rad);
}

void PlaceCheck::begin_known() {
  search_.keep_newest(0);
  last_known_.reset();
  is_known_ = true;
  was_known_ = false;
}

void PlaceCheck::begin_anywhere() {
  search_.keep_newest(0);
  is_known_ = false;
  was_known_ = false;
}

void PlaceCheck::doubt() {
  if (is_known()) {
    search_.keep_newest(1);
    is_known_ = false;
    was_known_ = true;
  }
}

CheckedBelief PlaceCheck::check(const PoseBelief& believed,
                                StopScan scan,
                                const Contradicts& contradicts) {
  if (std::none_of(scan.readings.begin(), scan.readings.end(), is_usable)) {
    return {believed, {}};
  }
  if (is_known() && believed.status == LocalizationStatus::kLost) {
    begin_anywhere();
    was_known_ = true;
  }
  T_odom_robot_ = scan.T_odom_robot;
  search_.add(std::move(scan));
  return is_known() && !believed.hypotheses.empty() ? check_known(believed, contradicts)
                                                    : check_anywhere(believed, contradicts);
}

/// A filter that did not go where the wheels went may have taken another place for the known one.
double PlaceCheck::prior_share(const FollowedPose& now) const {
  if (!last_known_) {
    return 1.0;
  }
  const Pose2 way = last_known_->T_odom_robot.inverse() * now.T_odom_robot;
  const Pose2 off = (last_known_->T_map_robot * way).inverse() * now.T_map_robot;
  const double variance_m2 = geometry::square(params_.departure_m) +
                             geometry::square(params_.departure_per_m * way.position_m().norm());
  const double variance_rad2 = geometry::square(params_.departure_rad) +
                               geometry::square(params_.departure_per_rad * way.heading_rad());
  const double chi_squared = off.position_m().squaredNorm() / variance_m2 +
                             geometry::square(off.heading_rad()) / variance_rad2;
  return std::exp(-0.5 * std::max(0.0, chi_squared - params_.usual_departure));
}

std::vector<FoundPlace> PlaceCheck::places_by_scans(const Pose2& T_map_believed,
                                                    std::size_t newest,
                                                    double prior_share) {
  std::vector<FoundPlace> places = search_.search(newest, T_map_believed);
  const auto others = static_cast<double>(std::count_if(
      places.begin(), places.end(), [](const FoundPlace& place) { return !place.is_believed; }));
  for (FoundPlace& place : places) {
    place.odds *= place.is_believed ? prior_share * (1.0 - params_.elsewhere_chance)
                                    : params_.elsewhere_chance / others;
  }
  return places;
}

CheckedBelief PlaceCheck::check_known(const PoseBelief& believed, const Contradicts& contradicts) {
  const PoseHypothesis& followed = believed.hypotheses.front();
  const FollowedPose now{followed.T_map_robot, T_odom_robot_};
  const double share = prior_share(now);
  double min_probability = 1.0;
  std::size_t scans_of_min = 0;
  std::vector<FoundPlace> places;
  for (std::size_t newest = 1; newest <= search_.scans(); newest *= 2) {
    std::vector<FoundPlace> found = places_by_scans(followed.T_map_robot, newest, share);
    const double probability = probability_of_believed(found);
    if (probability < min_probability) {
      min_probability = probability;
      scans_of_min = newest;
      places = std::move(found);
    }
  }
  if (min_probability < params_.lost_below) {
    search_.keep_newest(scans_of_min);
    is_known_ = false;
    was_known_ = true;
    return check_anywhere(believed, contradicts);
  }
  last_known_ = now;
  CheckedBelief checked{believed, {}};
  if (min_probability < params_.claimed_from) {
    for (FoundPlace& place : places) {
      place.T_map_robot = place.is_believed ? followed.T_map_robot : place.T_map_robot;
    }
    checked.belief.hypotheses = hypotheses_of(places, params_.told_from);
    checked.belief.status = believed.status == LocalizationStatus::kLocalized
                                ? LocalizationStatus::kRecovering
                                : believed.status;
  }
  const double told = std::min(min_probability, checked.belief.hypotheses.front().probability);
  checked.belief.lost_probability = std::max(believed.lost_probability, 1.0 - told);
  return checked;
}

CheckedBelief PlaceCheck::check_anywhere(const PoseBelief& believed,
                                         const Contradicts& contradicts) {
  CheckedBelief checked{believed, {}};
  std::vector<PoseHypothesis> places =
      hypotheses_of(search_.search(search_.scans()), params_.told_from);
  if (places.empty()) {
    return checked;
  }
  PoseHypothesis& first = places.front();
  if (is_followed(first, believed)) {
    first.T_map_robot = believed.hypotheses.front().T_map_robot;
    first.covariance = believed.hypotheses.front().covariance;
  } else {
    checked.T_map_restart = first.T_map_robot;
  }
  const bool gave_up = believed.status == LocalizationStatus::kLost;
  const bool is_lost = std::exchange(was_known_, false) && (gave_up || checked.T_map_restart);
  const bool is_claimed =
      first.probability >= params_.claimed_from && !contradicts(first.T_map_robot);
  checked.belief.lost_probability = 1.0 - first.probability;
  checked.belief.hypotheses = std::move(places);
  checked.belief.status = is_lost      ? LocalizationStatus::kLost
                          : is_claimed ? LocalizationStatus::kLocalized
                                       : LocalizationStatus::kRecovering;
  if (is_claimed) {
    begin_known();
    last_known_ = {checked.belief.hypotheses.front().T_map_robot, T_odom_robot_};
  }
  return checked;
}

}  // namespace echomap::localization

// SPDX-License-Identifier: MIT
#include "host/localization/place_check.hpp"

#include <algorithm>

#include "host/geometry/square.hpp"

namespace echomap::localization {
namespace {

/// How well a search tells a pose.
constexpr double kFoundStddevM = 0.1;
constexpr double kFoundStddevRad = 0.1;

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

}  // namespace

PlaceCheck::PlaceCheck(ObservationModel& model, const PlaceCheckParams& params)
    : params_(params), search_(model, params.search) {}

void PlaceCheck::begin_known(double elsewhere_chance) {
  search_.keep_newest(0);
  elsewhere_chance_ = std::max(elsewhere_chance, params_.elsewhere_chance);
}

void PlaceCheck::begin_anywhere() {
  search_.keep_newest(0);
  elsewhere_chance_.reset();
}

void PlaceCheck::doubt() {
  if (is_known()) {
    search_.keep_newest(1);
    elsewhere_chance_.reset();
  }
}

CheckedBelief PlaceCheck::check(const PoseBelief& believed,
                                const geometry::Pose2& T_odom_robot,
                                std::span<const RangeReading> readings) {
  if (believed.status == LocalizationStatus::kLost) {
    begin_anywhere();
  }
  search_.add(T_odom_robot, readings);
  return is_known() && !believed.hypotheses.empty() ? check_known(believed)
                                                    : check_anywhere(believed);
}

double PlaceCheck::probability_of(const geometry::Pose2& T_map_believed, std::size_t newest) {
  double believed = 0.0;
  double elsewhere = 0.0;
  std::size_t others = 0;
  for (const FoundPlace& place : search_.search(newest, T_map_believed)) {
    const bool is_believed = search_.is_same_place(place.T_map_robot, T_map_believed);
    (is_believed ? believed : elsewhere) += place.odds;
    others += is_believed ? 0 : 1;
  }
  if (others == 0) {
    return 1.0;
  }
  // The chance is spread evenly over the other places.
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): where the place is known
  elsewhere *= *elsewhere_chance_ / static_cast<double>(others);
  return believed / (believed + elsewhere);
}

CheckedBelief PlaceCheck::check_known(const PoseBelief& believed) {
  double least = 1.0;
  std::size_t scans_of_least = 0;
  for (std::size_t newest = 1; newest <= search_.scans(); newest *= 2) {
    const double probability = probability_of(believed.hypotheses.front().T_map_robot, newest);
    if (probability < least) {
      least = probability;
      scans_of_least = newest;
    }
  }
  if (least < params_.lost_below) {
    search_.keep_newest(scans_of_least);
    elsewhere_chance_.reset();
    CheckedBelief lost = check_anywhere(believed);
    lost.belief.status = LocalizationStatus::kLost;
    return lost;
  }
  CheckedBelief checked{believed, {}};
  checked.belief.lost_probability = std::max(believed.lost_probability, 1.0 - least);
  if (checked.belief.status == LocalizationStatus::kLocalized &&
      checked.belief.lost_probability > 1.0 - params_.claimed_from) {
    checked.belief.status = LocalizationStatus::kRecovering;
  }
  return checked;
}

CheckedBelief PlaceCheck::check_anywhere(const PoseBelief& believed) {
  CheckedBelief checked{believed, {}};
  std::vector<PoseHypothesis> places =
      hypotheses_of(search_.search(search_.scans()), params_.told_from);
  if (places.empty()) {
    return checked;
  }
  PoseHypothesis& first = places.front();
  const bool is_followed =
      !believed.hypotheses.empty() &&
      search_.is_same_place(first.T_map_robot, believed.hypotheses.front().T_map_robot);
  if (is_followed) {
    first.T_map_robot = believed.hypotheses.front().T_map_robot;
    first.covariance = believed.hypotheses.front().covariance;
  } else {
    checked.T_map_restart = first.T_map_robot;
  }
  const double probability = first.probability;
  checked.belief.hypotheses = std::move(places);
  checked.belief.lost_probability = 1.0 - probability;
  const bool is_claimed = probability >= params_.claimed_from;
  if (is_claimed) {
    begin_known(1.0 - probability);
  }
  if (believed.status != LocalizationStatus::kLost) {
    checked.belief.status =
        is_claimed ? LocalizationStatus::kLocalized : LocalizationStatus::kRecovering;
  }
  return checked;
}

}  // namespace echomap::localization

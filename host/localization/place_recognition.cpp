// SPDX-License-Identifier: MIT
#include "host/localization/place_recognition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace echomap::localization {

namespace {

double difference_m(const std::optional<double>& one,
                    const std::optional<double>& other,
                    double max_m) {
  if (one.has_value() != other.has_value()) {
    return max_m;
  }
  return one ? std::min(std::abs(*one - *other), max_m) : 0.0;
}

/// Of a scan against one that is turned by so many steps.
double mean_difference_m(const RoundScan& scan,
                         const RoundScan& place,
                         std::size_t shift,
                         double max_m) {
  double sum_m = 0.0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    sum_m += difference_m(scan[i], place[(i + shift) % place.size()], max_m);
  }
  return sum_m / static_cast<double>(scan.size());
}

void validate(const RoundScan& scan, std::span<const RoundScan> places, double max_m) {
  const bool sizes_ok =
      !scan.empty() && std::all_of(places.begin(), places.end(), [&](const RoundScan& place) {
        return place.size() == scan.size();
      });
  if (!sizes_ok || !(max_m > 0.0)) {
    throw std::invalid_argument(
        "place recognition: scans have as many ranges as each other, and at least one; a "
        "difference counts for something");
  }
}

}  // namespace

std::optional<RecognisedPlace> recognise_place(const RoundScan& scan,
                                               std::span<const RoundScan> places,
                                               double max_m) {
  validate(scan, places, max_m);
  if (places.empty()) {
    return std::nullopt;
  }
  RecognisedPlace best;
  best.difference_m = std::numeric_limits<double>::infinity();
  best.next_difference_m = std::numeric_limits<double>::infinity();
  const double step_rad = 2.0 * std::numbers::pi / static_cast<double>(scan.size());
  for (std::size_t number = 0; number < places.size(); ++number) {
    double min_m = std::numeric_limits<double>::infinity();
    std::size_t turned = 0;
    for (std::size_t shift = 0; shift < scan.size(); ++shift) {
      const double mean_m = mean_difference_m(scan, places[number], shift, max_m);
      if (mean_m < min_m) {
        min_m = mean_m;
        turned = shift;
      }
    }
    if (min_m < best.difference_m) {
      best = {number, step_rad * static_cast<double>(turned), min_m, best.difference_m};
    } else {
      best.next_difference_m = std::min(best.next_difference_m, min_m);
    }
  }
  return best;
}

}  // namespace echomap::localization

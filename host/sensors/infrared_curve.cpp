// SPDX-License-Identifier: MIT
#include "host/sensors/infrared_curve.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace echomap::sensors {

InfraredCurve::InfraredCurve(std::vector<InfraredPoint> points) : points_(std::move(points)) {
  const auto positive = [](const InfraredPoint& point) {
    return point.counts > 0.0 && point.range_m > 0.0;
  };
  const auto out_of_order = [](const InfraredPoint& near, const InfraredPoint& far) {
    return far.counts >= near.counts || far.range_m <= near.range_m;
  };
  if (points_.size() < 2 || !std::ranges::all_of(points_, positive) ||
      std::ranges::adjacent_find(points_, out_of_order) != points_.end()) {
    throw std::invalid_argument(
        "infra-red curve: two points or more, counts falling and ranges growing");
  }
}

std::optional<double> InfraredCurve::range_m(double counts) const {
  if (counts < points_.back().counts) {
    return std::nullopt;
  }
  const auto far = std::ranges::find_if(
      points_, [counts](const InfraredPoint& point) { return point.counts <= counts; });
  if (far == points_.begin()) {
    return far->range_m;
  }
  const InfraredPoint& near = *(far - 1);
  const double share = std::log(near.counts / counts) / std::log(near.counts / far->counts);
  return near.range_m * std::pow(far->range_m / near.range_m, share);
}

}  // namespace echomap::sensors

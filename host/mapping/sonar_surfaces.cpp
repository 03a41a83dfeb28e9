// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/mapping/region_bearing.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::mapping {

namespace {

/// So many readings in a row that disagree end a region: more than both looks at one bearing.
constexpr int kStrangersThatEnd = 3;
/// What cuts a region short moves its middle at most so far.
constexpr double kMaxAsideRad = geometry::radians(16.0);

struct Region {
  double bearing_rad = 0.0;
  double range_m = 0.0;
  /// Its outermost members as seen from the bearing, to the left positive.
  double rightmost_rad = std::numeric_limits<double>::infinity();
  double leftmost_rad = -std::numeric_limits<double>::infinity();
  std::vector<std::size_t> members;
  /// Readings between the members that disagree.
  std::size_t strangers = 0;

  double score() const {
    return static_cast<double>(members.size()) - static_cast<double>(strangers);
  }
  double middle_rad() const { return bearing_rad + 0.5 * (leftmost_rad + rightmost_rad); }
  double half_width_rad() const { return 0.5 * (leftmost_rad - rightmost_rad); }
};

Eigen::Vector2d center_of(const Scan& scan) {
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  for (const auto& reading : scan) {
    sum_m += reading.T_map_sonar.position_m();
  }
  return scan.empty() ? sum_m : Eigen::Vector2d(sum_m / static_cast<double>(scan.size()));
}

std::vector<sensors::Beam> looks_from(const Eigen::Vector2d& center_m, const Scan& scan) {
  std::vector<sensors::Beam> looks;
  for (const auto& reading : scan) {
    if (const auto echo_m = echo_point_m(reading)) {
      const Eigen::Vector2d offset_m = *echo_m - center_m;
      looks.push_back({std::atan2(offset_m.y(), offset_m.x()), offset_m.norm()});
    } else {
      looks.push_back({reading.T_map_sonar.heading_rad(), std::nullopt});
    }
  }
  return looks;
}

/// The first of the ranges that have the most others within the tolerance; empty where there is
/// none.
std::optional<double> most_shared_m(const std::vector<double>& ranges_m, double tolerance_m) {
  std::vector<double> sorted_m = ranges_m;
  std::sort(sorted_m.begin(), sorted_m.end());
  std::optional<double> most_shared_m;
  std::ptrdiff_t most = 0;
  for (const double candidate_m : ranges_m) {
    const auto first = std::partition_point(sorted_m.begin(), sorted_m.end(), [&](double range_m) {
      return candidate_m - range_m > tolerance_m;
    });
    const auto last = std::partition_point(first, sorted_m.end(), [&](double range_m) {
      return range_m - candidate_m <= tolerance_m;
    });
    if (last - first > most) {
      most = last - first;
      most_shared_m = candidate_m;
    }
  }
  return most_shared_m;
}

/// Takes regions out of the looks of one scan, one after the other.
class RegionFinder {
 public:
  RegionFinder(std::vector<sensors::Beam> looks, const SonarSurfaceParams& params)
      : looks_(std::move(looks)), params_(params), leftwards_(looks_.size()) {
    std::iota(leftwards_.begin(), leftwards_.end(), std::size_t{0});
    rightwards_ = leftwards_;
    const auto bearing = [this](std::size_t i) { return looks_[i].bearing_rad; };
    std::stable_sort(leftwards_.begin(), leftwards_.end(), [&](std::size_t a, std::size_t b) {
      return bearing(a) < bearing(b);
    });
    std::stable_sort(rightwards_.begin(), rightwards_.end(), [&](std::size_t a, std::size_t b) {
      return bearing(a) > bearing(b);
    });
  }

  /// The region with the highest score among the looks that are left; empty where none is one.
  std::optional<Region> take_best() {
    std::optional<Region> best;
    for (const sensors::Beam& look : looks_) {
      auto region = centred_region_near(look.bearing_rad);
      if (region && (!best || region->score() > best->score())) {
        best = std::move(region);
      }
    }
    if (best) {
      for (const std::size_t member : best->members) {
        looks_[member].range_m.reset();
      }
    }
    return best;
  }

 private:
  bool agrees(const sensors::Beam& look, double depth_m, double off_rad) const {
    return look.range_m && std::abs(*look.range_m - range_off_foot_m(depth_m, off_rad, params_)) <=
                               params_.depth_tolerance_m;
  }

  /// The depth that most readings within half a beam of the bearing share.
  std::optional<double> common_depth_m(double bearing_rad) const {
    std::vector<std::size_t> near;
    for (const bool left : {true, false}) {
      walk(bearing_rad, left, params_.beam_half_angle_rad, [&](std::size_t index, double) {
        if (looks_[index].range_m) {
          near.push_back(index);
        }
        return true;
      });
    }
    std::sort(near.begin(), near.end());
    std::vector<double> ranges_m(near.size());
    std::transform(near.begin(), near.end(), ranges_m.begin(), [this](std::size_t index) {
      return looks_[index].range_m.value_or(0.0);
    });
    const auto most_shared = most_shared_m(ranges_m, params_.depth_tolerance_m);
    return most_shared ? std::optional(mean_near_m(ranges_m, *most_shared)) : std::nullopt;
  }

  /// Mean of the ranges that are as far as this one.
  double mean_near_m(const std::vector<double>& ranges_m, double range_m) const {
    double sum_m = 0.0;
    std::size_t count = 0;
    for (const double other_m : ranges_m) {
      const bool near = std::abs(other_m - range_m) <= params_.depth_tolerance_m;
      sum_m += near ? other_m : 0.0;
      count += near ? 1 : 0;
    }
    return sum_m / static_cast<double>(count);
  }

  /// Where among the looks, in their order to that side, those begin that lie there.
  std::size_t begin_of_side(double bearing_rad, bool left) const {
    const auto& side = left ? leftwards_ : rightwards_;
    const auto first = std::partition_point(side.begin(), side.end(), [&](std::size_t i) {
      return left ? looks_[i].bearing_rad < bearing_rad : looks_[i].bearing_rad >= bearing_rad;
    });
    return static_cast<std::size_t>(first - side.begin());
  }

  /// Hands the looks to one side of a bearing to `take`, outwards, with how far to the left they
  /// are, up to `reach_rad` and until it answers false.
  template <class Take>
  void walk(double bearing_rad, bool left, double reach_rad, const Take& take) const {
    const auto& side = left ? leftwards_ : rightwards_;
    const double from_rad = geometry::wrap_angle(bearing_rad);
    const std::size_t begin = begin_of_side(from_rad, left);
    for (std::size_t i = 0; i < side.size(); ++i) {
      const std::size_t index = side[(begin + i) % side.size()];
      const double off_rad = geometry::angle_between(from_rad, looks_[index].bearing_rad);
      if ((off_rad >= 0.0) != left || std::abs(off_rad) > reach_rad || !take(index, off_rad)) {
        return;
      }
    }
  }

  /// Follows one side until the readings stop agreeing, a quarter of a turn at most.
  void grow(Region& region, bool left) const {
    int strangers = 0;
    walk(region.bearing_rad, left, 0.5 * std::numbers::pi, [&](std::size_t index, double off_rad) {
      if (agrees(looks_[index], region.range_m, std::abs(off_rad))) {
        region.members.push_back(index);
        region.strangers += static_cast<std::size_t>(std::exchange(strangers, 0));
        region.leftmost_rad = std::max(region.leftmost_rad, off_rad);
        region.rightmost_rad = std::min(region.rightmost_rad, off_rad);
        return true;
      }
      return ++strangers < kStrangersThatEnd;
    });
  }

  std::optional<Region> region_at(double bearing_rad) const {
    const auto depth_m = common_depth_m(bearing_rad);
    if (!depth_m) {
      return std::nullopt;
    }
    Region region;
    region.bearing_rad = bearing_rad;
    region.range_m = *depth_m;
    grow(region, true);
    grow(region, false);
    return region;
  }

  std::optional<Region> centred_region_near(double bearing_rad) const {
    auto region = region_at(bearing_rad);
    if (region && is_surface(*region)) {
      region = region_at(region->middle_rad());
    }
    return region && is_surface(*region) ? region : std::nullopt;
  }

  bool is_surface(const Region& region) const {
    const auto members = static_cast<double>(region.members.size());
    const auto all = members + static_cast<double>(region.strangers);
    return region.members.size() >= params_.min_readings && members >= params_.min_agreement * all;
  }

  std::vector<sensors::Beam> looks_;  ///< Without the range once a region has claimed the reading.
  const SonarSurfaceParams& params_;
  /// Indices of the looks by their bearing, rising and falling.
  std::vector<std::size_t> leftwards_;
  std::vector<std::size_t> rightwards_;
};

/// How far a wall reaches for sure to one side of the region's middle. Beyond the beam's edge its
/// answers come from ever farther off: readings that are longer in the mean are of something else.
double reach_m(const Region& region,
               const std::vector<sensors::Beam>& looks,
               const SonarSurfaceParams& params,
               bool left) {
  const double edge_rad = params.beam_edge * params.beam_half_angle_rad;
  double longer_m = 0.0;
  double max_beyond_rad = 0.0;
  for (const std::size_t member : region.members) {
    const double off_rad = geometry::angle_between(region.middle_rad(), looks[member].bearing_rad);
    const double beyond_rad = (left ? off_rad : -off_rad) - edge_rad;
    if (beyond_rad > 0.0) {
      longer_m += looks[member].range_m.value_or(0.0) - params.max_longer_m -
                  range_off_foot_m(region.range_m, std::abs(off_rad), params);
      max_beyond_rad = std::max(max_beyond_rad, beyond_rad);
    }
  }
  return longer_m <= 0.0 ? region.range_m * std::tan(max_beyond_rad) : 0.0;
}

SonarSurface surface_of(const Region& region,
                        const std::vector<sensors::Beam>& looks,
                        const SonarSurfaceParams& params) {
  const double wider_rad =
      std::max(0.0, region.half_width_rad() - params.beam_edge * params.beam_half_angle_rad);
  const double within_rad = std::min(region.half_width_rad(), kMaxAsideRad);
  const double bearing_rad =
      likely_bearing_rad(looks, region.middle_rad(), within_rad, region.range_m, params);
  const double off_rad = geometry::angle_between(bearing_rad, region.bearing_rad);
  return {bearing_rad,
          region.range_m,
          region.range_m * std::tan(wider_rad),
          region.members.size(),
          reach_m(region, looks, params, false),
          reach_m(region, looks, params, true),
          region.rightmost_rad + off_rad,
          region.leftmost_rad + off_rad};
}

}  // namespace

bool SonarSurface::is_heard_towards(double towards_rad) const {
  const double off_rad = geometry::angle_between(bearing_rad, towards_rad);
  return off_rad >= rightmost_rad && off_rad <= leftmost_rad;
}

ScanSurfaces moved(ScanSurfaces scan, const geometry::Pose2& T_to_from) {
  scan.center_m = T_to_from * scan.center_m;
  for (SonarSurface& surface : scan.surfaces) {
    surface.bearing_rad = geometry::wrap_angle(surface.bearing_rad + T_to_from.heading_rad());
  }
  for (sensors::Beam& look : scan.looks) {
    look.bearing_rad = geometry::wrap_angle(look.bearing_rad + T_to_from.heading_rad());
  }
  return scan;
}

ScanSurfaces find_surfaces(const Scan& scan, const SonarSurfaceParams& params) {
  ScanSurfaces found;
  found.center_m = center_of(scan);
  found.looks = looks_from(found.center_m, scan);
  RegionFinder finder(found.looks, params);
  while (true) {
    const auto region = finder.take_best();
    if (!region) {
      return found;
    }
    found.surfaces.push_back(surface_of(*region, found.looks, params));
  }
}

}  // namespace echomap::mapping

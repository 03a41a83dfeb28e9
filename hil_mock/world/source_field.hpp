// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace echomap::world {

class FloorPlan;

/// What comes out of a source.
enum class SourceKind : std::uint8_t {
  kRadiation,  ///< Gamma rays: solids weaken them.
  kLight,      ///< Solids stop it, glass too.
};

/// "radiation" or "light".
std::string_view name_of(SourceKind kind);

/// A point from which something comes, and which nobody bumps into.
struct Source {
  SourceKind kind = SourceKind::kRadiation;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  /// A metre away and without anything between: pulses per second of a counter with a sensitivity
  /// of 1, or lux.
  double strength = 0.0;
  /// Between the sources' and the sensors' heights, metres.
  double height_m = 0.1;
};

/// What is there without a source, in the same units.
struct Backgrounds {
  double radiation_per_s = 0.0;
  double light_lux = 0.0;
};

/// Concrete for the gamma rays of caesium 137: 0.0775 cm2/g at 662 keV and 2.3 g/cm3 (NIST XCOM),
/// which is 17.8 per metre.
inline constexpr double kConcretePerM = 17.8;

/// What all sources of a kind and the background add up to at a point: inverse square of the
/// distance, and the law of Beer and Lambert along the straight way through all that stands; people
/// weaken nothing.
double field_at(const FloorPlan& plan, SourceKind kind, const Eigen::Vector2d& point_m);

/// Integral of the attenuation along the straight way between two points, 1; what is outside of the
/// room is solid.
double optical_depth(const FloorPlan& plan,
                     const Eigen::Vector2d& from_m,
                     const Eigen::Vector2d& to_m);

/// Sources of radiation as the command line has them, each "X,Y,STRENGTH" in the world's metres;
/// the one word "none" for no source. Throws std::invalid_argument for anything else.
std::vector<Source> parse_sources(const std::vector<std::string>& texts);

}  // namespace echomap::world

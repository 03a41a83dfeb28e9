// SPDX-License-Identifier: MIT
#include "host/mapping/range_gate.hpp"

#include <cmath>
#include <random>

#include <gmock/gmock.h>

#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kToleranceM = 0.05;

Sighting seen_from(double x_m, double y_m, double range_m) {
  return sighting_of({{x_m, y_m}, {{0.0, range_m, 0.0, 9}}, {}}, 0, 0);
}

double range_m(const EchoFeature& feature, const Sighting& sighting) {
  return view_from(sighting.center_m, feature).range_m;
}

TEST(RangeGate, LetsPassWhatIsAsFarOffAsItWasHeard) {
  const EchoFeature wall{LandmarkKind::kWall, {2.0, 0.0}};
  RangeGate gate({seen_from(0.5, 3.0, 1.54), seen_from(0.5, 3.0, 1.56), seen_from(1.0, -7.0, 0.96)},
                 kToleranceM);
  EXPECT_THAT(gate.passing(wall), ElementsAre(0, 2));
  EXPECT_THAT(gate.passing({LandmarkKind::kPoint, {2.0, 3.0}}), ElementsAre(0));
  EXPECT_THAT(gate.passing({LandmarkKind::kPoint, {2.36, 3.0}, 0.3}), ElementsAre(0, 1));
}

TEST(RangeGate, IsClosedToWhatWasTaken) {
  RangeGate gate({seen_from(0.0, 0.0, 1.0), seen_from(0.0, 0.0, 1.0)}, kToleranceM);
  gate.close(0);
  EXPECT_THAT(gate.passing({LandmarkKind::kPoint, {1.0, 0.0}}), ElementsAre(1));
  EXPECT_THAT(gate.passing({LandmarkKind::kWall, {1.0, 0.0}}), ElementsAre(1));
  gate.close(1);
  EXPECT_THAT(gate.passing({LandmarkKind::kPoint, {1.0, 0.0}}), IsEmpty());
}

TEST(RangeGate, NeverHoldsBackWhatFits) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place_m(-3.0, 3.0);
  std::uniform_real_distribution<double> off_m(-1.2 * kToleranceM, 1.2 * kToleranceM);
  for (const EchoFeature& feature : {EchoFeature{LandmarkKind::kWall, {3.5, 0.7}},
                                     EchoFeature{LandmarkKind::kPoint, {0.4, 0.3}},
                                     EchoFeature{LandmarkKind::kPoint, {0.4, 0.3}, 0.36}}) {
    std::vector<Sighting> sightings;
    for (int i = 0; i < 1000; ++i) {
      sightings.push_back(seen_from(place_m(random), place_m(random), 0.0));
      sightings.back().surface.range_m =
          std::max(0.0, range_m(feature, sightings.back()) + off_m(random));
    }
    RangeGate gate(sightings, kToleranceM);
    const auto& passing = gate.passing(feature);
    std::size_t fitting = 0;
    for (std::size_t i = 0; i < sightings.size(); ++i) {
      const double misfit_m =
          std::abs(range_m(feature, sightings[i]) - sightings[i].surface.range_m);
      if (misfit_m <= kToleranceM) {
        ++fitting;
        EXPECT_THAT(passing, testing::Contains(i));
      }
    }
    EXPECT_LT(passing.size(), fitting + 100) << "it lets pass far more than fits";
  }
}

}  // namespace
}  // namespace echomap::mapping

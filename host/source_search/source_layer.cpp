// SPDX-License-Identifier: MIT
#include "host/source_search/source_layer.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::source_search {

using geometry::CellIndex;
using mapping::CellBounds;
using mapping::CellField;

namespace {

using SourceJson = nlohmann::ordered_json;

/// Hypotheses that the expected rate is the mean of.
constexpr std::size_t kRateSamples = 100;

CellField field_over_map(const SourceBelief& belief, double resolution_m) {
  geometry::ParameterValidator("source layer").positive_finite("resolution_m", resolution_m);
  const mapping::RasterMap& map = belief.grid().map();
  const CellField any({}, resolution_m);
  const Eigen::Vector2d size_m = map.resolution_m() * Eigen::Vector2d(map.columns(), map.rows());
  return CellField(CellBounds{any.cell_at(map.origin_m()), any.cell_at(map.origin_m() + size_m)},
                   resolution_m);
}

double rate_at(const SourceBelief& belief,
               const std::vector<SourceHypothesis>& hypotheses,
               const Eigen::Vector2d& at_m) {
  const FieldReading reading{at_m, 0.0, 1.0, 0.0};
  double rate = 0.0;
  for (const SourceHypothesis& hypothesis : hypotheses) {
    double expected = hypothesis.background;
    if (hypothesis.at_m) {
      expected +=
          hypothesis.strength *
          belief.grid()
              .response_at(reading, *hypothesis.at_m, hypothesis.edge_m, hypothesis.shielding)
              .response;
    }
    rate += hypothesis.probability * expected;
  }
  return rate;
}

/// A tenth of a millimetre, and of a thousandth of what a probability is.
double rounded(double value) { return std::round(value * 1e4) / 1e4 + 0.0; }

SourceJson json_of(const LogEstimate& estimate) {
  if (estimate.median <= 0.0) {
    return nullptr;
  }
  return {{"median", rounded(estimate.median)}, {"log_stddev", rounded(estimate.log_stddev)}};
}

}  // namespace

CellField source_density(const SourceBelief& belief, double resolution_m) {
  CellField density = field_over_map(belief, resolution_m);
  const CellField probability = belief.place_probability();
  const auto per_m2 = static_cast<float>(1.0 / (resolution_m * resolution_m));
  for (std::size_t i = 0; i < probability.size(); ++i) {
    const CellIndex cell = density.cell_at(probability.center_m(probability.cell(i)));
    if (density.holds(cell)) {
      density[density.index(cell)] += per_m2 * probability[i];
    }
  }
  return density;
}

CellField expected_rate(const SourceBelief& belief, double resolution_m) {
  CellField rate = field_over_map(belief, resolution_m);
  const auto hypotheses = belief.sample(kRateSamples, 0.5);
  for (std::size_t i = 0; i < rate.size(); ++i) {
    rate[i] = static_cast<float>(rate_at(belief, hypotheses, rate.center_m(rate.cell(i))));
  }
  return rate;
}

std::string source_json(const SourceEstimate& estimate, const SourceBeliefParams& params) {
  SourceJson json;
  json["verdict"] = name_of(estimate.verdict);
  json["none_probability"] = rounded(estimate.none_probability);
  json["unseen_probability"] = rounded(estimate.unseen_probability);
  json["min_strength"] = params.grid.field.min_strength;
  json["best_m"] = {rounded(estimate.best_m.x()), rounded(estimate.best_m.y())};
  json["found_radius_m"] = params.found_radius_m;
  json["within_probability"] = rounded(estimate.within_probability);
  json["radius_95_m"] = rounded(estimate.radius_95_m);
  json["strength"] = json_of(estimate.strength);
  json["background"] = json_of(estimate.background);
  json["unit"] = params.grid.field.kind == SensorKind::kPulses ? "pulses per second" : "level";
  return json.dump(2) + "\n";
}

}  // namespace echomap::source_search

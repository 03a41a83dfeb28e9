// SPDX-License-Identifier: MIT
#include "host/apps/source_layer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "host/source_search/source_layer.hpp"

namespace echomap::apps {
namespace {

constexpr double kCellM = 0.1;
constexpr double kShowPeriodS = 1.0;

live_page::TeamField field_of(const source_search::SourceBelief& belief) {
  const mapping::CellField density = source_search::source_density(belief, kCellM);
  float highest = 0.0F;
  for (std::size_t i = 0; i < density.size(); ++i) {
    highest = std::max(highest, density[i]);
  }
  live_page::TeamField field;
  field.origin_m = density.center_m(density.bounds().min) - Eigen::Vector2d::Constant(0.5 * kCellM);
  field.resolution_m = kCellM;
  field.columns = static_cast<std::size_t>(density.bounds().max.x - density.bounds().min.x + 1);
  for (std::size_t i = 0; i < density.size(); ++i) {
    const float share = highest > 0.0F ? density[i] / highest : 0.0F;
    field.cells.push_back(static_cast<std::uint8_t>(std::lround(255.0F * share)));
  }
  return field;
}

}  // namespace

live_page::TeamSource shown_source(const source_search::SourceBelief& belief) {
  const source_search::SourceEstimate& estimate = belief.estimate();
  const bool is_undecided = estimate.verdict == source_search::SourceVerdict::kUndecided;
  live_page::TeamSource shown;
  shown.verdict = is_undecided ? "searching" : source_search::name_of(estimate.verdict);
  if (estimate.verdict != source_search::SourceVerdict::kNone) {
    shown.at_m = estimate.best_m;
    shown.radius_m = estimate.radius_95_m;
  }
  shown.none_probability = estimate.none_probability;
  shown.field = field_of(belief);
  return shown;
}

void SourceLayer::publish(double time_s,
                          const source_search::SourceBelief* belief,
                          live_page::RunPublisher& publisher) {
  if (belief == nullptr || (shown_s_ && time_s < *shown_s_ + kShowPeriodS)) {
    return;
  }
  const live_page::TeamSource source = shown_source(*belief);
  if (shown_s_ && source.field->cells == shown_cells_ && source.verdict == shown_verdict_) {
    return;
  }
  shown_s_ = time_s;
  shown_cells_ = source.field->cells;
  shown_verdict_ = source.verdict;
  publisher.add_team(time_s, {{}, source});
}

}  // namespace echomap::apps

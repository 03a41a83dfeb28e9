// SPDX-License-Identifier: MIT
#include "host/source_search/source_explorer.hpp"

#include <utility>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::source_search {

SourceExplorer::SourceExplorer(std::shared_ptr<SourceSearch> search,
                               const SourceReadings& readings,
                               double max_s)
    : search_(std::move(search)), readings_(readings), max_s_(max_s) {
  geometry::ParameterValidator("source explorer").positive("max_s", max_s);
}

exploration::Motion SourceExplorer::next(const pipeline::Snapshot& snapshot,
                                         exploration::MotionResult last) {
  if (readings_.elapsed_s() > max_s_) {
    return exploration::Finished{exploration::FinishReason::kStopLimit};
  }
  search_->set_readings(readings_.placed(snapshot));
  return search_->next(snapshot, last);
}

}  // namespace echomap::source_search

// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>

#include "host/source_search/source_readings.hpp"
#include "host/source_search/source_search.hpp"

namespace echomap::source_search {

/// Runs a SourceSearch on the readings of one robot: before each decision it sets all readings so
/// far, where the map has them now.
class SourceExplorer final : public exploration::Explorer {
 public:
  /// `readings` must outlive this; `search` is shared with the caller, who reads its result. Ends
  /// at its stop limit `max_s` seconds after the first reading. Throws std::invalid_argument where
  /// that is not above 0.
  SourceExplorer(std::shared_ptr<SourceSearch> search,
                 const SourceReadings& readings,
                 double max_s = std::numeric_limits<double>::infinity());

  exploration::Motion next(const pipeline::Snapshot& snapshot,
                           exploration::MotionResult last) override;
  exploration::Intent intent() const override { return search_->intent(); }

 private:
  std::shared_ptr<SourceSearch> search_;
  const SourceReadings& readings_;
  double max_s_;
};

}  // namespace echomap::source_search

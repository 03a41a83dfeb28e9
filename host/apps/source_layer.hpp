// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/live_page/run_publisher.hpp"
#include "host/live_page/team_state.hpp"
#include "host/source_search/source_belief.hpp"

namespace echomap::apps {

/// A belief as the live page has it: the field is 255 where the source is most probable.
live_page::TeamSource shown_source(const source_search::SourceBelief& belief);

/// Shows on a live page where one robot believes the source to be: once a second at most, and where
/// what it shows has changed.
class SourceLayer {
 public:
  /// Null before the first reading.
  void publish(double time_s,
               const source_search::SourceBelief* belief,
               live_page::RunPublisher& publisher);

 private:
  std::optional<double> shown_s_;
  std::vector<std::uint8_t> shown_cells_;
  std::string shown_verdict_;
};

}  // namespace echomap::apps

// SPDX-License-Identifier: MIT
#include "host/apps/localize_troubles.hpp"

#include <fmt/format.h>

namespace echomap::apps {

using localization::LocalizerOutcome;

std::string why_nowhere(const pipeline::LogLocalizer& localizer,
                        const std::filesystem::path& log,
                        const std::filesystem::path& map) {
  if (localizer.scans() == 0) {
    return log.string() + " holds no ranges";
  }
  const LocalizerOutcome outcome = localizer.belief().outcome;
  const bool is_the_map =
      outcome == LocalizerOutcome::kUnknownMap || outcome == LocalizerOutcome::kNoFloor;
  return fmt::format("{}: {}", (is_the_map ? map : log).string(), localization::text_of(outcome));
}

std::vector<std::string> troubles_of(const pipeline::LogLocalizer& localizer) {
  std::vector<std::string> troubles;
  const LocalizerOutcome start = localizer.start_outcome();
  if (start != LocalizerOutcome::kMoved) {
    troubles.push_back(fmt::format("not there at the start: {}; looked for everywhere",
                                   localization::text_of(start)));
  }
  if (localizer.late_scans() > 0) {
    troubles.push_back(fmt::format("{} scans were left out: {}",
                                   localizer.late_scans(),
                                   localization::text_of(LocalizerOutcome::kTimeRanBack)));
  }
  return troubles;
}

}  // namespace echomap::apps

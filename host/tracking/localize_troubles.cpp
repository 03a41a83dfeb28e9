// SPDX-License-Identifier: MIT
#include "host/tracking/localize_troubles.hpp"

#include <fmt/format.h>

namespace echomap::tracking {

using localization::LocalizerOutcome;

std::string why_nowhere(const pipeline::RobotLocalizer& localizer,
                        const std::filesystem::path& log,
                        const std::filesystem::path& map) {
  if (localizer.scans() == 0) {
    return log.string() +
           " holds no ranges, and no contacts of a robot without them\n"
           "  next: name the log or the run of a robot that has driven in that room";
  }
  const LocalizerOutcome outcome = localizer.belief().outcome;
  const bool is_the_map =
      outcome == LocalizerOutcome::kUnknownMap || outcome == LocalizerOutcome::kNoFloor;
  return fmt::format("{}: {}", (is_the_map ? map : log).string(), localization::text_of(outcome));
}

std::optional<std::string> trouble_of_start(LocalizerOutcome start) {
  if (start == LocalizerOutcome::kMoved) {
    return std::nullopt;
  }
  return fmt::format("cannot start at that pose: {}; localizing globally",
                     localization::text_of(start));
}

std::vector<std::string> troubles_of(const pipeline::RobotLocalizer& localizer) {
  std::vector<std::string> troubles;
  if (const auto trouble = trouble_of_start(localizer.start_outcome())) {
    troubles.push_back(*trouble);
  }
  if (localizer.late_scans() > 0) {
    troubles.push_back(fmt::format("{} scans were skipped: {}",
                                   localizer.late_scans(),
                                   localization::text_of(LocalizerOutcome::kTimeRanBack)));
  }
  return troubles;
}

}  // namespace echomap::tracking

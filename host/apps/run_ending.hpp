// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "host/console/exit_code.hpp"
#include "host/console/shell_line.hpp"
#include "host/diagnosis/self_check.hpp"
#include "host/exploration/coverage.hpp"
#include "host/exploration/explorer.hpp"
#include "host/exports/summary_json.hpp"
#include "host/localization/localizer_preset.hpp"
#include "host/mapping/expected_wall_error.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/session/fault_advice.hpp"
#include "host/session/robot_profile.hpp"
#include "host/session/session_end.hpp"

namespace echomap::apps {

/// How a run has ended: what its closing paragraph, summary.json and its exit code say.
struct RunEnding {
  std::string outcome;  ///< "complete", "stop-limit", "link-lost", ...
  console::ExitCode code = console::ExitCode::kOk;
  std::string why;   ///< A sentence.
  std::string next;  ///< What to do, or a command to type.

  /// What was asked is there.
  bool finished() const { return code == console::ExitCode::kOk; }
};

/// Commands to type after an exploration.
struct NextCommands {
  std::string use;    ///< Of a finished map.
  std::string go_on;  ///< Where the room is unfinished.
  std::string find;   ///< Where the robot is lost.
  std::string again;  ///< Anew, without the map.
};

/// A map with less of the floor in reach than this is unfinished.
constexpr double kFinishedShare = 0.95;

/// Empty for a robot without a sonar: it sees nothing before it is there.
std::optional<exploration::Coverage> coverage_of(const pipeline::Snapshot& snapshot,
                                                 const session::RobotProfile& profile);

/// What the walls of a map by multiscan SLAM are expected to be off by; empty for other maps.
std::optional<mapping::ExpectedWallError> wall_error_of(const pipeline::RobotPipeline& pipeline);

/// Whether the robot, not the room, ended the strategy: a part is broken, it is held, or the like.
bool is_trouble(exploration::FinishReason reason);

/// Of an exploration that its strategy has ended. A strategy that has done what it set out to do
/// has finished only where the map, too, has what the robot can reach; a robot that hears nothing
/// has no `coverage`, and its strategy is believed.
RunEnding ending_of(exploration::FinishReason reason,
                    const std::optional<exploration::Coverage>& coverage,
                    const std::optional<mapping::ExpectedWallError>& walls,
                    const NextCommands& next);

/// The same where an earlier map of the run, of so much floor, could not be joined to its last one
/// of `seen_m2`: the last map is not all where the earlier one has more.
RunEnding with_previous_map(RunEnding ending,
                            double previous_m2,
                            double seen_m2,
                            const NextCommands& next);

/// Of an exploration whose session has ended before its strategy, for that reason.
RunEnding ending_of(session::SessionEnd end, const std::string& reason, const NextCommands& next);

/// Of a robot with a fault that forbids a map; `again` is the command to repeat.
RunEnding ending_of_fault(const session::FaultAdvice& advice, const std::string& again);

/// The same ending of a robot with a fault that does not.
RunEnding with_fault(RunEnding ending, const session::FaultAdvice& advice);

/// Of a log or record that was played until `outcome` "finished", "interrupted" or "log-damaged",
/// which `damage` then tells, into the map of the folder `out`.
RunEnding ending_of_replay(const std::string& outcome,
                           const std::string& damage,
                           const std::string& out);

/// Of a localization that has ended so, for the places where the robot may be in the map at the
/// end: `report` is that of tracking::to_json. Several places that fit are told with their
/// probabilities. `localize` are the words of the command.
RunEnding ending_of_localization(const std::string& outcome,
                                 const nlohmann::ordered_json& report,
                                 const console::CommandWords& localize);

/// The same by a paper's settings: where they end they cannot tell whether they are right, so that
/// a localized robot is no success. Unchanged for the default preset.
RunEnding ending_of_preset(localization::LocalizerPreset preset,
                           RunEnding ending,
                           const console::CommandWords& localize);

/// The same as entries of a report: outcome, finished, why and next.
nlohmann::ordered_json to_json(const RunEnding& ending);

/// Sets outcome, finished, why and next.
void describe_ending(const RunEnding& ending, exports::RunSummary& summary);

/// Sets what is expected of the walls, where something is.
void describe_walls(const std::optional<mapping::ExpectedWallError>& walls,
                    exports::RunSummary& summary);

/// The same as entries of the summary.
exports::CoverageSummary summary_of(const exploration::Coverage& coverage);

/// The self-check's diagnosis as an entry of the summary; empty without one.
std::optional<exports::FaultSummary> summary_of(
    const std::optional<diagnosis::Diagnosis>& diagnosis);

/// The closing paragraph: on stderr, where it is not finished as an error. `saved` is what is there
/// nevertheless.
void print_ending(const RunEnding& ending, std::string_view saved = "the map so far");

}  // namespace echomap::apps

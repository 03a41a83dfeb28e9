// SPDX-License-Identifier: MIT
#include "host/apps/run_ending.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/console/print.hpp"
#include "host/geometry/angle.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/pipeline/preset_names.hpp"
#include "host/slam/multiscan_slam.hpp"
#include "host/strategies/strategy_setup.hpp"

namespace echomap::apps {
namespace {

using console::ExitCode;
using exploration::Coverage;
using exploration::FinishReason;

/// A command that ends a piece of advice.
using Command = std::string NextCommands::*;

/// Of a strategy that could not go on: what the shell sees, why and what to do.
struct Trouble {
  FinishReason reason;
  ExitCode code;
  const char* why;
  const char* next;
  Command command = nullptr;
};

constexpr Trouble kTroubles[] = {
    {FinishReason::kCannotSense,
     ExitCode::kRuntimeError,
     "the sonar completed no sweep",
     "check the wiring of the pan drive and of the sonar"},
    {FinishReason::kStuck,
     ExitCode::kSafetyStop,
     "the robot is stuck: something holds it, or its wheels slip",
     "free it and start again"},
    {FinishReason::kLifted,
     ExitCode::kSafetyStop,
     "the robot was picked up and its pose is lost",
     "put it down and start again"},
    {FinishReason::kBatteryLow,
     ExitCode::kSafetyStop,
     "the battery is low",
     "charge it without moving the robot, then: ",
     &NextCommands::go_on},
    {FinishReason::kSonarSilent,
     ExitCode::kRuntimeError,
     "the sonar does not answer: it is not connected, or it is dead",
     "check the sonar's wiring and its supply, then start again"},
    {FinishReason::kSonarStuck,
     ExitCode::kRuntimeError,
     "the sonar returns the same range in every direction",
     "check its wiring and remove whatever is right in front of it"},
    {FinishReason::kWheelFault,
     ExitCode::kSafetyStop,
     "a wheel does not turn, or its encoder does not count",
     "free the wheels and compare motors and encoders with docs/guides/wiring.md"},
    {FinishReason::kLost,
     ExitCode::kRuntimeError,
     "sonar readings contradict the map: the robot was carried, or its wheels slipped",
     "start again, or find it in its map: ",
     &NextCommands::find},
};

const Trouble* trouble_of(FinishReason reason) {
  const auto* trouble = std::find_if(std::begin(kTroubles),
                                     std::end(kTroubles),
                                     [&](const Trouble& one) { return one.reason == reason; });
  return trouble == std::end(kTroubles) ? nullptr : trouble;
}

/// Why a strategy went no further although nothing kept it; empty where it was done.
std::string_view end_of(FinishReason reason) {
  switch (reason) {
    case FinishReason::kStopLimit:
      return "it came to the limit of its stops";
    case FinishReason::kNoNewGround:
      return "its last stops showed no new floor";
    case FinishReason::kNowhereToGo:
      return "it found no way on";
    case FinishReason::kWaypointsMissed:
      return "it could not reach all of its waypoints";
    case FinishReason::kNotBack:
      return "it could not reach its last waypoint";
    default:
      return "";
  }
}

std::string joined(std::string_view reason, std::string text) {
  return reason.empty() ? text : fmt::format("{}; {}", reason, text);
}

std::string text_of(const exploration::NarrowGap& gap) {
  return fmt::format("a gap of {:.2f} m at ({:.1f}, {:.1f}) was too narrow for it",
                     gap.width_m,
                     gap.at_m.x(),
                     gap.at_m.y());
}

std::string text_of_doors(const std::vector<geometry::Segment>& doors) {
  const Eigen::Vector2d at_m = exploration::before_m({doors.front()}, 0.0);
  return fmt::format("what is drawn as wall at ({:.1f}, {:.1f}) may be a door{}",
                     at_m.x(),
                     at_m.y(),
                     doors.size() > 1 ? fmt::format(", and {} more", doors.size() - 1) : "");
}

/// Rounded down: what is not all is not called all.
int percent(double share) { return static_cast<int>(100.0 * share); }

std::string text_of(const Coverage& coverage,
                    const std::optional<mapping::ExpectedWallError>& walls) {
  std::string text =
      fmt::format("the map has {} % of the floor that the robot can reach, {:.1f} m²",
                  percent(coverage.share()),
                  coverage.seen_m2);
  if (walls) {
    text +=
        fmt::format(", walls off by about {:.0f} cm (9 in 10 such maps: by less than {:.0f} cm)",
                    100.0 * walls->median_m,
                    100.0 * walls->p90_m);
  }
  if (coverage.share() < kFinishedShare && !coverage.places.empty()) {
    const auto& place = coverage.places.front();
    text += fmt::format(
        "; most of what is unseen is near ({:.1f}, {:.1f})", place.at_m.x(), place.at_m.y());
  }
  if (!coverage.gaps.empty()) {
    text += "; " + text_of(coverage.gaps.front());
  }
  if (coverage.share() >= kFinishedShare && !coverage.doors.empty()) {
    text += "; " + text_of_doors(coverage.doors);
  }
  return text;
}

/// How often the settings of a paper end at the robot (docs/algorithms/paper_localizers.md).
std::string record_of(localization::LocalizerPreset preset) {
  switch (preset) {
    case localization::LocalizerPreset::kNxt:
      return "with the paper's numbers 6 of 60 simulated runs in an empty room ended within 15 cm "
             "of the robot or of its twin half a turn away";
    case localization::LocalizerPreset::kCreate:
      return "with the paper's numbers 1 of 10 simulated runs ended within 15 cm of the robot";
    case localization::LocalizerPreset::kEpuck:
      return "with the paper's numbers 48 of 80 simulated runs ended within 3 cm of the robot";
    case localization::LocalizerPreset::kDefault:
      break;
  }
  return "";
}

}  // namespace

std::optional<Coverage> coverage_of(const pipeline::Snapshot& snapshot,
                                    const session::RobotProfile& profile) {
  if (!profile.has_sonar) {
    return std::nullopt;
  }
  const auto frontier = strategies::frontier_params(profile, std::nullopt);
  exploration::CoverageParams params;
  params.costs = frontier.navigator.costs;
  params.gain = frontier.gain;
  return exploration::coverage_of(snapshot, params);
}

std::optional<mapping::ExpectedWallError> wall_error_of(const pipeline::RobotPipeline& pipeline) {
  const auto* method = dynamic_cast<const slam::MultiscanSlam*>(pipeline.slam());
  if (method == nullptr) {
    return std::nullopt;
  }
  const mapping::RasterMap map = mapping::rasterize(*pipeline.snapshot().grid);
  return mapping::expected_wall_error(map, std::sqrt(method->belief().covariance(2, 2)));
}

bool is_trouble(FinishReason reason) { return trouble_of(reason) != nullptr; }

RunEnding ending_of(FinishReason reason,
                    const std::optional<Coverage>& coverage,
                    const std::optional<mapping::ExpectedWallError>& walls,
                    const NextCommands& next) {
  const std::string outcome = name_of(reason);
  if (const Trouble* trouble = trouble_of(reason)) {
    const std::string command = trouble->command != nullptr ? next.*trouble->command : "";
    return {outcome, trouble->code, trouble->why, trouble->next + command};
  }
  const std::string_view end = end_of(reason);
  if (!coverage) {
    return end.empty() ? RunEnding{outcome, ExitCode::kOk, "it did what it set out to do", next.use}
                       : RunEnding{outcome, ExitCode::kUnfinished, std::string(end), next.go_on};
  }
  const std::string why = joined(end, text_of(*coverage, walls));
  return coverage->share() >= kFinishedShare
             ? RunEnding{outcome, ExitCode::kOk, why, next.use}
             : RunEnding{outcome, ExitCode::kUnfinished, why, next.go_on};
}

RunEnding with_previous_map(RunEnding ending,
                            double previous_m2,
                            double seen_m2,
                            const NextCommands& next) {
  if (previous_m2 > seen_m2) {
    ending.why +=
        fmt::format("; but an earlier map, which could not be joined to it, has {:.1f} m² of floor",
                    previous_m2);
    if (ending.finished()) {
      ending.code = ExitCode::kUnfinished;
      ending.next = next.go_on;
    }
  }
  return ending;
}

RunEnding ending_of(session::SessionEnd end, const std::string& reason, const NextCommands& next) {
  constexpr std::string_view kNext = "\n  next: ";
  const auto at = reason.find(kNext);
  return {session::outcome_of(end),
          session::exit_code_of(end),
          reason.substr(0, at),
          at == std::string::npos ? next.go_on : reason.substr(at + kNext.size())};
}

RunEnding ending_of_fault(const session::FaultAdvice& advice, const std::string& again) {
  return {"robot-fault", ExitCode::kRobotFault, advice.what, advice.change + ", then: " + again};
}

RunEnding with_fault(RunEnding ending, const session::FaultAdvice& advice) {
  ending.why += fmt::format("; but {}: {}", advice.what, advice.change);
  return ending;
}

RunEnding ending_of_replay(const std::string& outcome,
                           const std::string& damage,
                           const std::string& out) {
  const std::string use = console::shell_line({"echomap", "localize", "--map", out});
  if (outcome == "finished") {
    return {outcome, ExitCode::kOk, "the log was played to its end", use};
  }
  return outcome == "interrupted"
             ? RunEnding{outcome, ExitCode::kInterrupted, "interrupted", "run it again"}
             : RunEnding{outcome, ExitCode::kRuntimeError, damage, "mend the log, or: " + use};
}

RunEnding ending_of_localization(const std::string& outcome,
                                 const nlohmann::ordered_json& report,
                                 const console::CommandWords& localize) {
  const std::string again = console::shell_line(localize);
  if (report.at("status") == "localized") {
    return {outcome, ExitCode::kOk, "the robot is localized", again};
  }
  std::string places;
  std::size_t count = 0;
  for (const auto& place : report.value("hypotheses", nlohmann::ordered_json::array())) {
    constexpr double kMayBe = 0.1;
    if (const double probability = place.at("probability"); probability >= kMayBe) {
      places += fmt::format("{}({:.2f}, {:.2f}, {:.0f} degrees) {:.2f}",
                            count == 0 ? "" : ", ",
                            place.at("x_m").get<double>(),
                            place.at("y_m").get<double>(),
                            geometry::degrees(place.at("heading_rad").get<double>()),
                            probability);
      ++count;
    }
  }
  const std::string why = count > 1
                              ? fmt::format("ambiguous: {} places fit: {}", count, places)
                              : "the robot is not localized: what it hears does not tell its place";
  return {outcome,
          ExitCode::kUnfinished,
          why,
          "let it drive on, or say where it starts: " + again + " --at X Y DEGREES"};
}

RunEnding ending_of_preset(localization::LocalizerPreset preset,
                           RunEnding ending,
                           const console::CommandWords& localize) {
  if (preset == localization::LocalizerPreset::kDefault || ending.code != ExitCode::kOk) {
    return ending;
  }
  ending.code = ExitCode::kUnfinished;
  ending.why = fmt::format(
      "the particles of preset {} agree, but a paper's settings cannot tell whether they are right:"
      " {}",
      pipeline::name_of(preset),
      record_of(preset));
  ending.next = "leave --preset out, to know how sure it is: " + console::shell_line(localize);
  return ending;
}

nlohmann::ordered_json to_json(const RunEnding& ending) {
  return {{"outcome", ending.outcome},
          {"finished", ending.finished()},
          {"why", ending.why},
          {"next", ending.next}};
}

void describe_ending(const RunEnding& ending, exports::RunSummary& summary) {
  summary.outcome = ending.outcome;
  summary.finished = ending.finished();
  summary.why = ending.why;
  summary.next = ending.next;
}

void describe_walls(const std::optional<mapping::ExpectedWallError>& walls,
                    exports::RunSummary& summary) {
  if (walls) {
    summary.expected_wall_rmse_m = walls->median_m;
    summary.wall_rmse_p90_m = walls->p90_m;
  }
}

exports::CoverageSummary summary_of(const Coverage& coverage) {
  exports::CoverageSummary summary{coverage.share(), coverage.seen_m2, coverage.unseen_m2};
  for (const exploration::UnseenPlace& place : coverage.places) {
    summary.places.push_back({place.at_m.x(), place.at_m.y(), place.area_m2});
  }
  for (const exploration::NarrowGap& gap : coverage.gaps) {
    summary.gaps.push_back({gap.at_m.x(), gap.at_m.y(), gap.width_m, gap.behind_m2});
  }
  for (const geometry::Segment& door : coverage.doors) {
    const Eigen::Vector2d at_m = exploration::before_m({door}, 0.0);
    summary.possible_doors.push_back({at_m.x(), at_m.y(), door.length_m()});
  }
  return summary;
}

std::optional<exports::FaultSummary> summary_of(
    const std::optional<diagnosis::Diagnosis>& diagnosis) {
  return diagnosis ? std::optional(exports::FaultSummary{name_of(diagnosis->fault.kind),
                                                         diagnosis->fault.value,
                                                         diagnosis->log_odds,
                                                         diagnosis->stops})
                   : std::nullopt;
}

void print_ending(const RunEnding& ending, std::string_view saved) {
  if (ending.finished()) {
    console::print(fmt::format("finished: {}\n  next: {}", ending.why, ending.next));
  } else {
    spdlog::error("not finished; {} is saved: {}\n  next: {}", saved, ending.why, ending.next);
  }
}

}  // namespace echomap::apps

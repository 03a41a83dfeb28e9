// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/commands.hpp"
#include "host/apps/interrupt.hpp"
#include "host/apps/localize_troubles.hpp"
#include "host/apps/progress_bar.hpp"
#include "host/apps/report.hpp"
#include "host/datasets/open_log.hpp"
#include "host/exports/pgm_yaml.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/geometry/angle.hpp"
#include "host/pipeline/log_localizer.hpp"

namespace echomap::apps {
namespace {

using localization::LocalizationStatus;

/// How well one knows where a robot is that is said to be somewhere.
constexpr double kStartStdM = 0.3;
constexpr double kStartStdRad = 0.2;

std::string name_of(LocalizationStatus status) {
  switch (status) {
    case LocalizationStatus::kLost:
      return "lost";
    case LocalizationStatus::kRecovering:
      return "recovering";
    case LocalizationStatus::kLocalized:
      return "localized";
  }
  return "";
}

std::filesystem::path map_file(const std::filesystem::path& map) {
  return std::filesystem::is_directory(map) ? map / "map.yaml" : map;
}

std::string text_of(const localization::PoseHypothesis& hypothesis) {
  const geometry::Pose2& pose = hypothesis.T_map_robot;
  return fmt::format("{:.2f}, {:.2f} m, {:.0f} degrees",
                     pose.x_m(),
                     pose.y_m(),
                     geometry::degrees(pose.heading_rad()));
}

/// Says so whenever the status changes.
class StatusLine {
 public:
  void tell(const localization::PoseBelief& belief, std::size_t scans) {
    if (belief.status == last_ || belief.hypotheses.empty()) {
      return;
    }
    last_ = belief.status;
    say(fmt::format("  {} at scan {}: {} (not there with probability {:.2f})",
                    name_of(belief.status),
                    scans,
                    text_of(belief.hypotheses.front()),
                    belief.lost_probability));
  }

 private:
  LocalizationStatus last_ = LocalizationStatus::kRecovering;
};

/// Feeds the log until it ends or the user has had enough; answers whether it ended.
bool feed(datasets::LogReader& log, pipeline::LogLocalizer& localizer, ProgressBar& progress) {
  StatusLine status;
  while (!interrupted()) {
    const auto record = log.next();
    if (!record) {
      return true;
    }
    const std::size_t updates = localizer.updates();
    localizer.add(*record);
    if (localizer.updates() != updates) {
      progress.show(log.progress(), fmt::format("{} scans", localizer.scans()));
      status.tell(localizer.belief(), localizer.scans());
    }
  }
  return false;
}

nlohmann::ordered_json to_json(const LocalizeOptions& options,
                               const pipeline::LogLocalizer& localizer) {
  const localization::PoseBelief& belief = localizer.belief();
  nlohmann::ordered_json json{{"log", options.log.filename().string()},
                              {"scans", localizer.scans()},
                              {"unused_scans", localizer.unused_scans()},
                              {"late_scans", localizer.late_scans()},
                              {"updates", localizer.updates()},
                              {"status", name_of(belief.status)},
                              {"lost_probability", belief.lost_probability},
                              {"hypotheses", nlohmann::ordered_json::array()}};
  for (const localization::PoseHypothesis& hypothesis : belief.hypotheses) {
    const geometry::Pose2& pose = hypothesis.T_map_robot;
    json["hypotheses"].push_back({{"x_m", pose.x_m()},
                                  {"y_m", pose.y_m()},
                                  {"heading_rad", pose.heading_rad()},
                                  {"std_x_m", std::sqrt(hypothesis.covariance(0, 0))},
                                  {"std_y_m", std::sqrt(hypothesis.covariance(1, 1))},
                                  {"std_heading_rad", std::sqrt(hypothesis.covariance(2, 2))},
                                  {"probability", hypothesis.probability}});
  }
  return json;
}

}  // namespace

ExitCode run_localize(const LocalizeOptions& options) {
  const auto log = datasets::open_log(options.log, options.format);
  const mapping::RasterMap map = exports::read_pgm_yaml(map_file(options.map));
  const auto out = run_folder(options.out);
  prepare_outputs(out, options.json);
  pipeline::LogLocalizer localizer(map, {}, std::mt19937(options.seed));
  if (options.at.size() == 3) {
    localizer.start_at(
        {options.at[0], options.at[1], geometry::radians(options.at[2])}, kStartStdM, kStartStdRad);
  }
  ProgressBar progress(stderr, !options.headless);
  const bool has_ended = feed(*log, localizer, progress);
  progress.clear();
  if (localizer.belief().hypotheses.empty()) {
    throw CommandError(ExitCode::kRuntimeError, why_nowhere(localizer, options.log, options.map));
  }
  for (const std::string& trouble : troubles_of(localizer)) {
    spdlog::warn("{}", trouble);
  }
  exports::write_trajectory_tum(out / "trajectory.tum", localizer.trajectory());
  const auto report = to_json(options, localizer);
  write_report(out / "summary.json", report);
  write_report(options.json, report);
  say(fmt::format("{} after {} scans: {}",
                  name_of(localizer.belief().status),
                  localizer.scans(),
                  text_of(localizer.belief().hypotheses.front())));
  say("trajectory: " + (out / "trajectory.tum").string());
  return has_ended ? ExitCode::kOk : ExitCode::kInterrupted;
}

}  // namespace echomap::apps

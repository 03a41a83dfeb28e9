// SPDX-License-Identifier: MIT
#include "host/apps/run_writer.hpp"

#include <algorithm>
#include <utility>

#include <spdlog/spdlog.h>

#include "host/apps/link_report.hpp"
#include "host/apps/run_recording.hpp"
#include "host/apps/saved_map.hpp"
#include "host/exports/grid_csv.hpp"
#include "host/files/atomic_file.hpp"
#include "host/session/firmware_name.hpp"

namespace echomap::apps {

namespace fs = std::filesystem;

RunWriter::RunWriter(session::RobotContext& robot,
                     const exploration::Explorer& explorer,
                     const ExploreRun& run,
                     exports::RunSummary& summary)
    : robot_(robot),
      explorer_(explorer),
      out_(run.out),
      align_(run.align),
      before_s_(sim_seconds_of(run.resumed)),
      summary_(summary),
      split_bytes_(run.split_bytes) {}

void RunWriter::begin() {
  move_earlier_run_aside(out_);
  begin_recording(robot_, "explore", summary_, out_, split_bytes_);
}

void RunWriter::save() {
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
  summary_.sim_seconds = before_s_ + now_s(robot_.session());
  summary_.wall_seconds = wall.count();
  summary_.previous_maps = robot_.atlas().previous_maps().size();
  summary_.maps_joined = robot_.atlas().joins();
  describe_clock();
  describe_link();
  try {
    save_previous_maps();
    save_current_map();
    remove_joined_maps();
  } catch (const fs::filesystem_error& error) {
    throw files::FileError(error.what());
  }
}

void RunWriter::save_in_passing() {
  try {
    save();
  } catch (const files::FileError& error) {
    if (!std::exchange(warned_, true)) {
      spdlog::warn("cannot save the map: {}", error.what());
    }
  }
}

void RunWriter::save_current_map() {
  const exploration::StrategyProducts products = explorer_.products();
  if (products.phases > 0) {
    summary_.phases = products.phases;
    summary_.phases_reached = products.phases_reached;
  }
  save_map(robot_.atlas().pipeline(),
           robot_.profile(),
           out_,
           summary_,
           {.outline_m = products.outline_m, .align = align_});
  if (products.confidence) {
    exports::write_confidence_grid_csv(out_ / "confidence_grid.csv", *products.confidence);
  }
}

void RunWriter::save_previous_maps() {
  if (changes_saved_ == robot_.atlas().changes()) {
    return;
  }
  const auto& previous = robot_.atlas().previous_maps();
  for (std::size_t i = 0; i < previous.size(); ++i) {
    const fs::path folder = previous_map_of(out_, i + 1);
    exports::RunSummary summary = summary_;
    summary.outcome = "set-aside";
    summary.coverage.reset();
    summary.expected_wall_rmse_m.reset();
    summary.wall_rmse_p90_m.reset();
    fs::create_directories(folder);
    save_map(previous[i].pipeline, robot_.profile(), folder, summary, {.align = align_});
  }
  changes_saved_ = robot_.atlas().changes();
  previous_saved_ = std::max(previous_saved_, previous.size());
}

void RunWriter::remove_joined_maps() {
  for (; previous_saved_ > robot_.atlas().previous_maps().size(); --previous_saved_) {
    fs::remove_all(previous_map_of(out_, previous_saved_));
  }
}

void RunWriter::describe_clock() {
  const time::ClockSync& clock = robot_.session().link().clock();
  summary_.clock_rate_error_ppm = clock.rate_error_ppm();
  summary_.clock_uncertainty_us = clock.uncertainty_us();
  if (summary_.clock_rate_error_ppm && summary_.clock_uncertainty_us) {
    spdlog::debug("the robot's clock runs {:+.1f} ppm fast, +- {:.0f} us",
                  *summary_.clock_rate_error_ppm,
                  *summary_.clock_uncertainty_us);
  }
}

void RunWriter::describe_link() {
  const auto link = summary_of(robot_.session().link().statistics(), robot_.session().reconnects());
  spdlog::debug("{}", line_of(link));
  if (const auto losses = losses_between(summary_.link, link); !losses.empty()) {
    spdlog::warn("since the last stop the robot counted {}", losses);
  }
  summary_.link = link;
  if (const auto& robot = robot_.session().link().robot(); robot && summary_.firmware.empty()) {
    summary_.firmware = session::firmware_of(*robot);
  }
}

}  // namespace echomap::apps

// SPDX-License-Identifier: MIT
#include "host/apps/saved_map.hpp"

#include <string>
#include <system_error>

#include <fmt/format.h>

#include "host/exports/pose_graph_g2o.hpp"
#include "host/files/atomic_file.hpp"
#include "host/recording/session_file.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;

/// What one run writes beside its map and another does not.
constexpr const char* kOptionalFiles[] = {recording::kBagMetadataName,
                                          "confidence_grid.csv",
                                          "landmarks.csv",
                                          "pose_graph.g2o",
                                          "robot.toml"};

/// Renames a file or folder, in place of one that has that name.
void move_aside(const fs::path& from, const fs::path& to) {
  if (!exists(from)) {
    return;
  }
  std::error_code failure;
  fs::remove_all(to, failure);
  if (!failure) {
    fs::rename(from, to, failure);
  }
  if (failure) {
    throw files::FileError(from.string() + " is in the way: " + failure.message());
  }
}

/// Removes a file of an earlier run. Throws files::FileError.
void remove_earlier(const fs::path& path) {
  std::error_code failure;
  fs::remove(path, failure);
  if (failure) {
    throw files::FileError(path.string() + " is in the way: " + failure.message());
  }
}

void save_pose_graph(const pipeline::RobotPipeline& pipeline,
                     const fs::path& folder,
                     exports::RunSummary& summary) {
  if (const slam::SlamMethod* slam = pipeline.slam()) {
    exports::describe_uncertainty(slam->belief().covariance, summary);
    exports::write_pose_graph_g2o(folder / "pose_graph.g2o", pipeline.factor_graph());
    return;
  }
  remove_earlier(folder / "pose_graph.g2o");
}

}  // namespace

fs::path previous_map_of(const fs::path& run, std::size_t number) {
  return run / fmt::format("previous_{}", number);
}

void move_earlier_run_aside(const fs::path& out) {
  const fs::path recording = out / recording::kSessionFileName;
  if (exists(recording)) {
    for (std::size_t part = 0; exists(recording::part_of(out / kPreviousRecordingName, part));
         ++part) {
      remove_earlier(recording::part_of(out / kPreviousRecordingName, part));
    }
  }
  for (std::size_t part = 0; exists(recording::part_of(recording, part)); ++part) {
    move_aside(recording::part_of(recording, part),
               recording::part_of(out / kPreviousRecordingName, part));
  }
  for (std::size_t number = 1; exists(previous_map_of(out, number)); ++number) {
    const fs::path folder = previous_map_of(out, number);
    move_aside(folder, folder.string() + ".before");
  }
  for (const char* name : kOptionalFiles) {
    remove_earlier(out / name);
  }
}

void save_map(const pipeline::RobotPipeline& pipeline,
              const session::RobotProfile& profile,
              const fs::path& folder,
              exports::RunSummary& summary,
              exports::RunDrawing drawing) {
  const auto snapshot = pipeline.snapshot();
  exports::describe_snapshot(snapshot, summary);
  summary.outline_by_strategy = !drawing.outline_m.empty();
  save_pose_graph(pipeline, folder, summary);
  files::write_text_file(folder / kProfileName, profile.toml);
  if (profile.body_radius_m > 0.0) {
    drawing.robot_radius_m = profile.body_radius_m;
  }
  exports::write_run_directory(folder, snapshot, summary, drawing);
}

}  // namespace echomap::apps

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "host/apps/commands.hpp"
#include "host/apps/recorded_run.hpp"
#include "host/console/print.hpp"
#include "host/exports/carmen_log.hpp"
#include "host/exports/geojson.hpp"
#include "host/exports/map_gif.hpp"
#include "host/exports/map_json.hpp"
#include "host/exports/map_png.hpp"
#include "host/exports/map_svg.hpp"
#include "host/exports/observations_csv.hpp"
#include "host/exports/pgm_yaml.hpp"
#include "host/exports/pose_graph_g2o.hpp"
#include "host/exports/run_directory.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"
#include "host/mapping/room_outline.hpp"
#include "host/pipeline/observation_fork.hpp"
#include "host/recording/session_file.hpp"
#include "host/session/pipeline_setup.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;
using exports::RunPictures;

/// A run that was played again, and all that a file can be made of.
class PlayedRun {
 public:
  explicit PlayedRun(const ExportOptions& options, const fs::path& file)
      : options_(options),
        recording_(file),
        profile_(profile_of(recording_)),
        atlas_(session::atlas_for(profile_, recording_.fact("session", "slam"))) {
    throw_if_without_map(recording_);
    fork_.add(table_);
    fork_.add(atlas_);
    const PlayedPart part{.until_s = options.until_s};
    played_ =
        play(recording_, profile_, {sessions_, fork_, &atlas_}, part, [this] { keep_frame(); });
    if (played_.damage.empty()) {
      throw_if_empty(atlas_.record(), part, recording_);
    }
    report_ = read_report(options.run, recording_);
  }

  const Played& played() const { return played_; }
  const session::RobotProfile& profile() const { return profile_; }
  const pipeline::RobotPipeline& pipeline() const { return atlas_.pipeline(); }
  pipeline::Snapshot snapshot() const { return pipeline().snapshot(); }
  const exports::ObservationsCsv& table() const { return table_; }

  /// As `echomap explore` draws them.
  RunPictures pictures() const {
    exports::RunSummary summary;
    summary.world = report_.world;
    summary.robot = report_.robot;
    exports::RunDrawing drawing{.outline_m = outline_of(options_.run, report_, recording_),
                                .align = options_.align};
    if (profile_.body_radius_m > 0.0) {
      drawing.robot_radius_m = profile_.body_radius_m;
    }
    return exports::pictures_of(snapshot(), summary, drawing);
  }

  void write_gif(const fs::path& path) const {
    const RunPictures last = pictures();
    exports::MapAnimation animation(
        {.turn_rad = last.style.turn_rad,
         .robot_radius_m = last.style.robot_radius_m,
         .title = report_.world.empty() ? report_.robot : report_.world});
    for (const Frame& frame : frames_) {
      animation.add(
          frame.snapshot,
          mapping::room_outline(mapping::rasterize(*frame.snapshot.grid), *frame.snapshot.features),
          fmt::format("{} stops, {:.0f} s", frame.snapshot.stops, frame.elapsed_s));
    }
    animation.save(path);
  }

 private:
  struct Frame {
    pipeline::Snapshot snapshot;
    double elapsed_s = 0.0;
  };

  void keep_frame() {
    if (options_.to == "gif") {
      frames_.push_back({snapshot(), recording_.elapsed_s()});
    }
  }

  const ExportOptions& options_;
  recording::SessionReader recording_;
  session::RobotProfile profile_;
  pipeline::RobotAtlas atlas_;
  exports::ObservationsCsv table_;
  pipeline::ObservationFork fork_;
  pipeline::JoinedSessions sessions_{fork_};
  std::vector<Frame> frames_;
  Played played_;
  RunReport report_;
};

void write_pgm(const PlayedRun& run, const fs::path& path) {
  exports::write_pgm_yaml(fs::path(path).replace_extension(".yaml"), run.pictures().map);
}
void write_png(const PlayedRun& run, const fs::path& path) {
  const RunPictures pictures = run.pictures();
  exports::write_map_png(path, run.snapshot(), pictures.outline, pictures.style);
}
void write_svg(const PlayedRun& run, const fs::path& path) {
  const RunPictures pictures = run.pictures();
  exports::write_map_svg(path, run.snapshot(), pictures.outline, pictures.style);
}
void write_geojson(const PlayedRun& run, const fs::path& path) {
  const RunPictures pictures = run.pictures();
  exports::write_outline_geojson(path, pictures.outline, pictures.is_open);
}
void write_json(const PlayedRun& run, const fs::path& path) {
  exports::write_map_json(path, run.snapshot(), run.pictures().outline);
}
void write_csv(const PlayedRun& run, const fs::path& path) { run.table().save(path); }
void write_tum(const PlayedRun& run, const fs::path& path) {
  exports::write_trajectory_tum(path, *run.snapshot().trajectory);
}
void write_carmen(const PlayedRun& run, const fs::path& path) {
  exports::write_carmen_log(path, run.snapshot(), {.max_range_m = run.profile().range.max_range_m});
}
void write_gif(const PlayedRun& run, const fs::path& path) { run.write_gif(path); }
void write_g2o(const PlayedRun& run, const fs::path& path) {
  if (run.pipeline().slam() == nullptr) {
    throw CommandError(ExitCode::kRuntimeError,
                       "the run was placed by odometry alone and has no pose graph\n"
                       "  next: echomap replay --slam multiscan makes one");
  }
  exports::write_pose_graph_g2o(path, run.pipeline().factor_graph());
}

struct Export {
  std::string_view name;    ///< In --to.
  std::string_view ending;  ///< Of its file.
  void (*write)(const PlayedRun& run, const fs::path& path);
};

constexpr std::array kExports{
    Export{"pgm", "pgm", write_pgm},
    Export{"png", "png", write_png},
    Export{"svg", "svg", write_svg},
    Export{"geojson", "geojson", write_geojson},
    Export{"csv", "csv", write_csv},
    Export{"tum", "tum", write_tum},
    Export{"g2o", "g2o", write_g2o},
    Export{"carmen", "clf", write_carmen},
    Export{"json", "json", write_json},
    Export{"gif", "gif", write_gif},
};

/// The file that is written: the one that is named, or the run's name with the format's ending.
fs::path output_of(const ExportOptions& options, const Export& format) {
  if (!options.out.empty()) {
    return options.out;
  }
  const fs::path run = fs::absolute(options.run).lexically_normal();
  const fs::path name = run.filename().empty() ? run.parent_path().filename() : run.filename();
  const fs::path stem = name.extension() == ".mcap" ? name.stem() : name;
  return fs::path(stem.string() + "." + std::string(format.ending));
}

/// Throws CommandError where a file is in the way, or would be the recording itself.
void validate_output(const ExportOptions& options, const fs::path& out, const fs::path& recording) {
  const bool is_pgm = options.to == "pgm";
  if (is_pgm && out.extension() != ".pgm") {
    throw CommandError(ExitCode::kUsage,
                       out.string() +
                           " does not end with .pgm, as map.yaml beside it wants\n  next: "
                           "--out " +
                           fs::path(out).replace_extension(".pgm").string());
  }
  for (std::size_t part = 0; exists(recording::part_of(recording, part)); ++part) {
    if (exists(out) && fs::equivalent(out, recording::part_of(recording, part))) {
      throw CommandError(
          ExitCode::kUsage,
          out.string() + " is the recording itself\n  next: name another file with --out");
    }
  }
  for (const fs::path& file : {out, is_pgm ? fs::path(out).replace_extension(".yaml") : out}) {
    if (exists(file) && !options.force) {
      throw CommandError(
          ExitCode::kUsage,
          file.string() + " exists\n  next: name another file with --out, or add --force");
    }
  }
}

}  // namespace

std::vector<std::string> export_names() {
  std::vector<std::string> names;
  names.reserve(kExports.size());
  for (const Export& format : kExports) {
    names.emplace_back(format.name);
  }
  return names;
}

ExitCode run_export(const ExportOptions& options) {
  const Export& format = *std::find_if(
      kExports.begin(), kExports.end(), [&](const Export& one) { return one.name == options.to; });
  const auto file = recording_of(options.run);
  if (!file) {
    throw CommandError(ExitCode::kRuntimeError,
                       options.run.string() +
                           " is no recording of a run\n  next: name the run directory of echomap "
                           "explore, or its session.mcap");
  }
  const fs::path out = output_of(options, format);
  validate_output(options, out, *file);
  const PlayedRun run(options, *file);
  format.write(run, out);
  console::print(fmt::format("{}: {:.0f} s of the robot, {} stops",
                             out.string(),
                             run.played().duration_s,
                             run.snapshot().stops));
  if (!run.played().damage.empty()) {
    throw files::FileError("the recording is damaged, " + out.string() +
                           " holds what comes before: " + run.played().damage);
  }
  return ExitCode::kOk;
}

}  // namespace echomap::apps

// SPDX-License-Identifier: MIT
#include "tests/benchmarks/recording_cost.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <stdexcept>

#include "host/pipeline/observation_fork.hpp"
#include "host/recording/session_file.hpp"
#include "host/recording/session_reader.hpp"
#include "host/session/child_process.hpp"
#include "host/session/pipeline_setup.hpp"
#include "host/session/session_player.hpp"
#include "host/session/temporary_folder.hpp"
#include "tests/support/median.hpp"

namespace echomap::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kTenMinutesS = 600.0;
constexpr int kRepetitions = 5;

double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A demo whose robot maps on for at least ten minutes: as often as the strategy has a next stop.
fs::path make_recording(const session::TemporaryFolder& folder) {
  session::ChildProcess demo({session::program_folder() / "echomap",
                              "demo",
                              "--headless",
                              "--emulator=mock",
                              "--world=office",
                              "--out=" + (folder / "live").string()},
                             folder / "live.log");
  demo.wait_for(std::chrono::minutes(20));
  const fs::path file = folder / "live" / recording::kSessionFileName;
  if (!exists(file)) {
    throw std::runtime_error("the demo left no recording");
  }
  return file;
}

/// Maps cost most and are the same with and without: they are made once, and the recorder is shown
/// the last of them after every stop.
struct Session {
  session::RobotProfile profile;
  pipeline::Snapshot map;
  double robot_s = 0.0;
};

Session read_session(const fs::path& file) {
  recording::SessionReader reader(file);
  Session read{
      session::parse_robot_profile(reader.attachment("robot.toml").value(), "robot.toml"), {}, 0.0};
  pipeline::RobotAtlas atlas = session::atlas_for(read.profile, "multiscan");
  pipeline::JoinedSessions sessions(atlas);
  session::SessionPlayer player(reader, read.profile, {sessions, atlas, &atlas});
  while (player.play_next()) {
  }
  read.map = atlas.pipeline().snapshot();
  read.robot_s = reader.elapsed_s();
  return read;
}

/// Processor time of playing the session, recorded into `out` unless that is empty.
double play_cpu_s(const fs::path& file, const Session& session, const fs::path& out) {
  const double begin_s = cpu_s();
  recording::SessionReader reader(file);
  recording::SessionRecorder recorder({session.profile.geometry, {0.2, 0.04, 2.3}, {}});
  pipeline::ObservationFork fork;
  if (!out.empty()) {
    recorder.open(out);
    fork.add(recorder);
  }
  pipeline::JoinedSessions sessions(fork);
  session::SessionPlayer player(
      reader, session.profile, {sessions, fork, nullptr, out.empty() ? nullptr : &recorder});
  while (player.play_next()) {
    if (player.has_ended_scan() && !out.empty()) {
      recorder.add_map(session.map);
    }
  }
  if (!out.empty()) {
    recorder.finish();
  }
  return cpu_s() - begin_s;
}

}  // namespace

std::vector<Figure> cost_figures() {
  const session::TemporaryFolder folder;
  const fs::path file = make_recording(folder);
  const Session session = read_session(file);
  std::vector<double> extra_s;
  for (int i = 0; i < kRepetitions; ++i) {
    const double without_s = play_cpu_s(file, session, {});
    extra_s.push_back(play_cpu_s(file, session, folder / "again.mcap") - without_s);
  }
  const double recorded_s = session.robot_s;
  const double mb = 1e-6 * static_cast<double>(fs::file_size(folder / "again.mcap"));
  return {{"recorded_robot_seconds", recorded_s, "s", 1, {}},
          {"mcap_cpu_percent", 100.0 * tests::median(extra_s) / recorded_s, "%", kRepetitions, {}},
          {"mcap_mb_per_10min", mb * kTenMinutesS / recorded_s, "MB", 1, {}}};
}

}  // namespace echomap::bench

// SPDX-License-Identifier: MIT
#include "tests/benchmarks/replayed_runs.hpp"

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "host/files/atomic_file.hpp"
#include "host/mcap/mcap_reader.hpp"
#include "host/recording/session_file.hpp"
#include "host/recording/session_reader.hpp"
#include "host/session/child_process.hpp"
#include "host/session/temporary_folder.hpp"

namespace echomap::bench {
namespace {

namespace fs = std::filesystem;
using session::ChildProcess;
using session::TemporaryFolder;
using Words = std::vector<std::string>;

constexpr std::chrono::minutes kMaxRunTime(20);
constexpr std::chrono::seconds kMaxStartTime(10);
/// From where the robot is carried to where, in the living room.
constexpr const char* kKidnap = "30,2,3.2,1.0,90";
constexpr const char* kReset = "board-reset@20";

std::string program(const std::string& name) { return session::program_folder() / name; }

/// True where the program ended with a map: as finished (0) or with floor left unseen (8).
bool ends_with_a_map(ChildProcess& process) {
  const std::optional<int> status = process.wait_for(kMaxRunTime);
  return status == 0 || status == 8;
}

bool wait_until_there(const std::vector<fs::path>& files) {
  const auto end = std::chrono::steady_clock::now() + kMaxStartTime;
  for (const fs::path& file : files) {
    while (!exists(file)) {
      if (std::chrono::steady_clock::now() > end) {
        return false;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  return true;
}

Words robot_of(const LiveRun& run, const TemporaryFolder& folder) {
  Words words{program("echomap-" + run.emulator),
              "--world=" + run.room,
              fmt::format("--seed={}", run.seed),
              "--link=" + (folder / "port").string(),
              "--lockstep=" + (folder / "lockstep").string()};
  if (!run.part_faults.empty()) {
    words.push_back("--part-faults=" + run.part_faults);
  }
  if (!run.kidnap.empty()) {
    words.push_back("--kidnap=" + run.kidnap);
  }
  return words;
}

bool explore(const LiveRun& run, const TemporaryFolder& folder) {
  const ChildProcess robot(robot_of(run, folder), folder / "robot.log");
  if (!wait_until_there({folder / "port", folder / "lockstep"})) {
    return false;
  }
  Words words{program("echomap"),
              "explore",
              "--headless",
              fmt::format("--seed={}", run.seed),
              "--port=" + (folder / "port").string(),
              "--lockstep=" + (folder / "lockstep").string(),
              "--out=" + (folder / "live").string()};
  if (run.stops > 0) {
    words.push_back(fmt::format("--stops={}", run.stops));
  }
  ChildProcess process(words, folder / "live.log");
  return ends_with_a_map(process);
}

bool replay_recording(const TemporaryFolder& folder) {
  ChildProcess process({program("echomap"),
                        "replay",
                        "--headless",
                        folder / "live" / recording::kSessionFileName,
                        "--out=" + (folder / "replay").string()},
                       folder / "replay.log");
  return ends_with_a_map(process);
}

bool is_same(const fs::path& one, const fs::path& other) {
  return exists(one) && exists(other) && files::read_text_file(one) == files::read_text_file(other);
}

/// Reads all that can be read of a recording; answers the log time of its last message.
std::uint64_t last_time_ns(const fs::path& file) {
  std::uint64_t last_ns = 0;
  mcap::McapReader reader(file);
  try {
    for (auto record = reader.next(); record; record = reader.next()) {
      if (const auto* message = std::get_if<mcap::Message>(&*record)) {
        last_ns = message->log_time_ns;
      }
    }
  } catch (const mcap::CutOffFile&) {
    return last_ns;
  }
  return last_ns;
}

double robot_seconds_of(const fs::path& file) {
  recording::SessionReader reader(file);
  while (reader.next()) {
  }
  return reader.elapsed_s();
}

}  // namespace

std::vector<LiveRun> live_runs(std::uint32_t seeds, const std::string& emulator, int stops) {
  std::vector<LiveRun> runs;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    LiveRun run;
    run.seed = seed;
    run.emulator = emulator;
    run.stops = stops;
    runs.push_back(run);
    run.part_faults = kReset;
    runs.push_back(run);
    run.part_faults.clear();
    run.kidnap = kKidnap;
    runs.push_back(run);
  }
  return runs;
}

ReplayedRun replay(const LiveRun& run) {
  const TemporaryFolder folder;
  ReplayedRun replayed;
  if (!explore(run, folder)) {
    replayed.differences = {"the run"};
    return replayed;
  }
  const auto start = std::chrono::steady_clock::now();
  if (!replay_recording(folder)) {
    replayed.differences = {"the replay"};
    return replayed;
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  replayed.replay_s = wall.count();
  const fs::path file = folder / "live" / recording::kSessionFileName;
  replayed.robot_s = robot_seconds_of(file);
  replayed.recording_mb = 1e-6 * static_cast<double>(fs::file_size(file));
  for (const char* name : {"map.pgm", "points.csv", "trajectory.tum"}) {
    if (!is_same(folder / "live" / name, folder / "replay" / name)) {
      replayed.differences.emplace_back(name);
    }
  }
  return replayed;
}

double seconds_lost_by_kill(double after_s, std::uint32_t seed) {
  const TemporaryFolder folder;
  const fs::path port = folder / "port";
  const ChildProcess robot({program("echomap-mock"),
                            fmt::format("--seed={}", seed),
                            "--link=" + port.string(),
                            "--duration=600"},
                           folder / "robot.log");
  if (!wait_until_there({port})) {
    return -1.0;
  }
  ChildProcess process({program("echomap"),
                        "explore",
                        "--headless",
                        "--port=" + port.string(),
                        "--out=" + (folder / "run").string()},
                       folder / "run.log");
  std::this_thread::sleep_for(std::chrono::duration<double>(after_s));
  const auto killed_at = std::chrono::system_clock::now().time_since_epoch();
  process.send(SIGKILL);
  process.wait_for(kMaxStartTime);
  try {
    const double last_s =
        1e-9 * static_cast<double>(last_time_ns(folder / "run" / recording::kSessionFileName));
    return std::chrono::duration<double>(killed_at).count() - last_s;
  } catch (const files::FileError&) {
    return -1.0;
  }
}

}  // namespace echomap::bench

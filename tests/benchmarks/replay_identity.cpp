// SPDX-License-Identifier: MIT
#include "tests/benchmarks/replay_identity.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <thread>

#include "host/files/atomic_file.hpp"
#include "host/session/child_process.hpp"
#include "host/session/temporary_folder.hpp"

namespace echomap::bench {
namespace {

using session::ChildProcess;
using session::TemporaryFolder;
using Words = std::vector<std::string>;

constexpr std::chrono::minutes kMaxRunTime(10);
constexpr std::chrono::seconds kMaxStartTime(10);
constexpr const char* kDemoRoom = "living_room";

std::string program(const std::string& name) { return session::program_folder() / name; }

/// True where the program ended with a map: as finished (0) or with floor left unseen (8).
bool ends_with_a_map(ChildProcess& process) {
  const std::optional<int> status = process.wait_for(kMaxRunTime);
  return status == 0 || status == 8;
}

bool demo(const LiveRun& run, const TemporaryFolder& folder) {
  Words command{program("echomap"),
                "demo",
                "--headless",
                "--no-kidnap",
                "--emulator=" + run.emulator,
                "--world=" + run.room,
                "--seed=" + std::to_string(run.seed),
                "--out=" + (folder / "live").string()};
  if (!run.part_faults.empty()) {
    command.push_back("--part-faults=" + run.part_faults);
  }
  ChildProcess process(command, folder / "live.log");
  return ends_with_a_map(process);
}

bool wait_until_there(const std::filesystem::path& one, const std::filesystem::path& other) {
  const auto end = std::chrono::steady_clock::now() + kMaxStartTime;
  while (!std::filesystem::exists(one) || !std::filesystem::exists(other)) {
    if (std::chrono::steady_clock::now() > end) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

/// The demo cannot carry its robot off before the map is there, so the mock does.
bool explore_carried_off(const LiveRun& run, const TemporaryFolder& folder) {
  const auto port = folder / "port";
  const auto lockstep = folder / "lockstep";
  const std::string seed = "--seed=" + std::to_string(run.seed);
  const ChildProcess robot({program("echomap-mock"),
                            seed,
                            "--world=" + run.room,
                            "--kidnap=" + run.kidnap,
                            "--link=" + port.string(),
                            "--lockstep=" + lockstep.string()},
                           folder / "robot.log");
  if (!wait_until_there(port, lockstep)) {
    return false;
  }
  ChildProcess process({program("echomap"),
                        "explore",
                        seed,
                        "--port=" + port.string(),
                        "--lockstep=" + lockstep.string(),
                        "--out=" + (folder / "live").string()},
                       folder / "live.log");
  return ends_with_a_map(process);
}

bool replay(const TemporaryFolder& folder) {
  ChildProcess process({program("echomap"),
                        "replay",
                        "--headless",
                        folder / "live",
                        "--out=" + (folder / "replay").string()},
                       folder / "replay.log");
  return ends_with_a_map(process);
}

bool is_same(const std::filesystem::path& one, const std::filesystem::path& other) {
  return std::filesystem::exists(one) && std::filesystem::exists(other) &&
         files::read_text_file(one) == files::read_text_file(other);
}

}  // namespace

std::vector<LiveRun> live_runs(std::uint32_t seeds, const std::string& emulator) {
  std::vector<LiveRun> runs;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    runs.push_back({kDemoRoom, seed});
  }
  for (const char* room : {"corridor", "l_room", "nxt_room", "office", "square_room"}) {
    runs.push_back({room});
  }
  runs.push_back({kDemoRoom, 1, "board-reset@20"});
  runs.push_back({kDemoRoom, 1, {}, "30,2,3.2,1.0,90"});
  for (LiveRun& run : runs) {
    run.emulator = emulator;
  }
  return runs;
}

std::vector<std::string> differences_of_replay(const LiveRun& run) {
  const TemporaryFolder folder;
  if (!(run.kidnap.empty() ? demo(run, folder) : explore_carried_off(run, folder))) {
    return {"the run"};
  }
  if (!replay(folder)) {
    return {"the replay"};
  }
  std::vector<std::string> differences;
  for (const char* file : {"map.pgm", "points.csv", "trajectory.tum"}) {
    if (!is_same(folder / "live" / file, folder / "replay" / file)) {
      differences.emplace_back(file);
    }
  }
  return differences;
}

}  // namespace echomap::bench

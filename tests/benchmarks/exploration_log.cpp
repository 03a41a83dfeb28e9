// SPDX-License-Identifier: MIT
#include "tests/benchmarks/exploration_log.hpp"

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

namespace echomap::bench {
namespace {

/// What a run is a function of; of files their names, since their folders come and go.
std::string key_of(const ExplorationCase& what, int seed) {
  const auto name = [](const std::filesystem::path& path) { return path.filename().string(); };
  return what.room + " " + what.strategy + " " + name(what.robot) + " " + name(what.course) + " " +
         name(what.body) + " " + (what.board.empty() ? what.emulator : what.board) + " " +
         std::to_string(seed);
}

/// Calls `visit` with the name and the place of every field of a run.
template <class Run, class Visit>
void each_field(Run& run, const Visit& visit) {
  visit("complete", run.complete);
  visit("outcome", run.outcome);
  visit("free_iou", run.free_iou);
  visit("wall_rmse_m", run.wall_rmse_m);
  visit("wall_recall", run.wall_recall);
  visit("sim_seconds", run.sim_seconds);
  visit("distance_m", run.distance_m);
  visit("bumps", run.bumps);
  visit("hard_collisions", run.hard_collisions);
  visit("corners", run.corners);
  visit("room_corners", run.room_corners);
  visit("corner_rmse_m", run.corner_rmse_m);
  visit("phases", run.phases);
  visit("phases_reached", run.phases_reached);
  visit("end_off_start_m", run.end_off_start_m);
  visit("max_distance_from_start_m", run.max_distance_from_start_m);
}

struct WriteField {
  nlohmann::ordered_json& line;
  template <class Value>
  void operator()(const char* name, const Value& value) const {
    line[name] = value;
  }
  template <class Value>
  void operator()(const char* name, const std::optional<Value>& value) const {
    if (value) {
      line[name] = *value;
    }
  }
};

struct ReadField {
  const nlohmann::ordered_json& line;
  template <class Value>
  void operator()(const char* name, Value& value) const {
    value = line.at(name).get<Value>();
  }
  template <class Value>
  void operator()(const char* name, std::optional<Value>& value) const {
    if (line.contains(name)) {
      value = line.at(name).get<Value>();
    }
  }
};

}  // namespace

ExplorationLog::ExplorationLog(std::filesystem::path path) : path_(std::move(path)) {
  std::ifstream file(path_);
  std::string text;
  std::uintmax_t whole_bytes = 0;
  while (std::getline(file, text)) {
    if (file.eof()) {
      std::fprintf(
          stderr, "%s: the last line is incomplete, and its run is made again\n", path_.c_str());
      std::filesystem::resize_file(path_, whole_bytes);
      return;
    }
    whole_bytes += text.size() + 1;
    try {
      const auto line = nlohmann::ordered_json::parse(text);
      each_field(runs_[line.at("run").get<std::string>()], ReadField{line});
    } catch (const nlohmann::json::exception& error) {
      throw std::runtime_error(path_.string() + " has a line that is no run: " + error.what());
    }
  }
}

std::optional<ExplorationRun> ExplorationLog::find(const ExplorationCase& what, int seed) const {
  const std::lock_guard lock(mutex_);
  const auto found = runs_.find(key_of(what, seed));
  return found == runs_.end() ? std::nullopt : std::optional(found->second);
}

void ExplorationLog::add(const ExplorationCase& what, int seed, const ExplorationRun& run) {
  if (path_.empty()) {
    return;
  }
  const std::lock_guard lock(mutex_);
  const std::string key = key_of(what, seed);
  runs_[key] = run;
  nlohmann::ordered_json line{{"run", key}};
  each_field(run, WriteField{line});
  std::ofstream file(path_, std::ios::app);
  file << line.dump() << std::endl;
  if (!file) {
    throw std::runtime_error("cannot write to " + path_.string());
  }
}

}  // namespace echomap::bench

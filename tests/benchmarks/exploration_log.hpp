// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "tests/benchmarks/exploration_runs.hpp"

namespace echomap::bench {

/// Runs that were made before, in a file of one JSON object a line, so that hours of them can be
/// made in parts. It knows a run by its arguments, not by the programs: a file is for one build.
/// Safe to use from several threads.
class ExplorationLog {
 public:
  /// Keeps nothing where `path` is empty. A last line that has no end, as whoever wrote it was
  /// killed, is told and taken off the file. Throws std::runtime_error for a line that is no run.
  explicit ExplorationLog(std::filesystem::path path = {});

  /// Empty for a run that was not made.
  std::optional<ExplorationRun> find(const ExplorationCase& what, int seed) const;
  /// Writes it to the end of the file. Throws std::runtime_error where that fails.
  void add(const ExplorationCase& what, int seed, const ExplorationRun& run);

 private:
  std::filesystem::path path_;
  mutable std::mutex mutex_;
  std::map<std::string, ExplorationRun> runs_;
};

}  // namespace echomap::bench

// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/integration/programs.hpp"

namespace echomap::test {

/// Paths of a staged run, in an empty folder whose path is short enough for a socket's.
struct StageFolder {
  explicit StageFolder(const std::filesystem::path& folder);

  std::filesystem::path root;
  std::filesystem::path run;       ///< The run directory.
  std::filesystem::path world;     ///< Of a room that is not bundled.
  std::filesystem::path port;      ///< Of a mock that runs by itself.
  std::filesystem::path lockstep;  ///< Of that, too.
};

/// What a staged run left behind.
struct StagedRun {
  Ended ended;
  /// What was said from the closing paragraph on, without what differs from run to run: RUN stands
  /// for the run directory, WORLD for the room's file, PORT for the port, N for a number.
  std::string closing_paragraph;
  std::optional<nlohmann::json> summary;  ///< summary.json; empty where there is none.
  std::set<std::string> saved;            ///< Names of what is in the run directory.
};

/// Drives a run to its end. Throws std::runtime_error where no run comes about.
using Stage = std::function<Ended(const StageFolder&)>;

/// A run that ends in a known way, and the golden text of that end.
struct StagedEnd {
  const char* name = "";
  Stage stage;
  int status = 0;
  const char* outcome = "";            ///< Of summary.json; empty where there is none.
  const char* closing_paragraph = "";  ///< As StagedRun has it.
  /// The map of what was explored before is saved, and has more floor than this.
  std::optional<double> mapped_m2 = std::nullopt;
};

/// By `echomap demo` on the native mock; `world` is the content of the file of a room that is not
/// bundled.
Stage demo_stage(std::vector<std::string> options, std::string world = "");

/// By `echomap explore` at the port of a mock, on a disk that has no room for a file of more than
/// `max_file_kb`.
Stage full_disk_stage(int stops, int max_file_kb);

/// The twelve ends of which a user has to know what to do next.
const std::vector<StagedEnd>& staged_ends();

/// Stages the end in an empty folder. Throws std::runtime_error where no run comes about.
StagedRun drive(const StagedEnd& end, const std::filesystem::path& folder);

/// How exit code, closing paragraph and run directory differ from the golden end, one line for
/// each; empty where the end is told as it should be.
std::vector<std::string> differences(const StagedEnd& golden, const StagedRun& run);

}  // namespace echomap::test

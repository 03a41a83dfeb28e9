// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace echomap::papers {

/// Runs of an echomap command that simulates robots, with the same arguments and other seeds.
struct Explorations {
  std::string name;                    ///< Of the folder of the runs.
  std::vector<std::string> arguments;  ///< Of the command, but for seed and run directory.
  std::uint32_t first_seed = 1;
  std::size_t runs = 20;
  std::vector<std::string> command{"demo"};  ///< Its words, as in {"fleet", "start"}.
};

/// One of them that has ended.
struct ExplorationRun {
  std::filesystem::path folder;
  nlohmann::json summary;  ///< summary.json of the run directory.
};

/// Called after each run with how many have ended.
using Progress = std::function<void(std::size_t ended)>;

/// Drives the runs below `folder`, two at a time, and returns them in the order of their seeds. A
/// run that ends without what it looks for (exit code 8) counts like any other. Throws
/// console::CommandError with the last line of its log where one fails, and kInterrupted where this
/// program is.
std::vector<ExplorationRun> run_explorations(const Explorations& explorations,
                                             const std::filesystem::path& folder,
                                             const Progress& progress);

/// The number at a JSON pointer of each summary that has one there, such as "/wall_rmse_m".
std::vector<double> numbers_of(const std::vector<ExplorationRun>& runs, const std::string& pointer);

}  // namespace echomap::papers

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/markdown_table.hpp"

namespace echomap::bench {

/// A fault that is built into a simulated robot, and what the self-check should call it.
struct BuiltFault {
  std::string part_faults;  ///< For `--part-faults`; empty for a sound robot.
  std::string name;         ///< `robot_fault.name` of summary.json; empty for none.
};

/// Those that robots are drawn from, each as often as the others.
const std::vector<BuiltFault>& built_faults();

/// A robot that explores until its self-check is over.
struct DrawnRobot {
  BuiltFault fault;
  std::string world;
  std::string body;  ///< "uno_2wd", or "uno_2wd_rough": measured by eye, on a floor that slips.
  int seed = 0;
};

/// What its run has said of it.
struct FaultFinding {
  DrawnRobot robot;
  bool has_run = false;
  std::string name;       ///< Empty where nothing was named.
  std::size_t stops = 0;  ///< After which it was.
};

/// `count` robots with a fault and as many sound ones, every second of these a rough one.
std::vector<DrawnRobot> draw_robots(const std::vector<std::string>& worlds,
                                    std::size_t count,
                                    int first_seed);

/// Drives the robot under the mock. Says on stderr why there is no run where there is none.
FaultFinding find_fault(const DrawnRobot& robot, const std::filesystem::path& folder);

/// Shares of the robots with a fault whose fault was named, or another one, and how many of the
/// sound ones were accused.
std::vector<Figure> fault_figures(const std::vector<FaultFinding>& findings);

/// A row for each name of a fault.
MarkdownTable fault_table(const std::vector<FaultFinding>& findings);

}  // namespace echomap::bench

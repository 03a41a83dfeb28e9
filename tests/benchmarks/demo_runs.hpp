// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// The demos that are run: what their command line says.
struct DemoRuns {
  int seeds = 20;
  std::string world = "living_room";
  std::string robot = "uno_2wd";
  std::string emulator = "simavr";
  std::string board;   ///< Instead of `emulator`; empty: none.
  std::string driver;  ///< Of the motors; empty: the profile's.
  std::string line = "direct";
  std::string faults;
  int jobs = 1;                     ///< Demos that run at a time.
  std::filesystem::path program{};  ///< Empty: the echomap beside this program.
};

/// What came of the demos.
struct DemoFigures {
  std::vector<Figure> figures;
  std::string emulator;  ///< Its name and version, as the runs report it; empty where none ended.
};

/// What the runs that ended by themselves say, as medians by column of the demo's report;
/// "runs_ended" counts these, "runs_finished" those that got what they were asked for (exit code
/// 0), "runs_complete" those of them that ended because nothing was left to look at, "relocalized"
/// those whose robot was found after it was carried off.
DemoFigures measure_demos(const DemoRuns& options);

/// Whether every run finished and had every bounded figure, with the medians within the bounds of
/// living_room; says on stderr what is not so.
bool demos_pass(const std::vector<Figure>& figures, double seeds);

}  // namespace echomap::bench

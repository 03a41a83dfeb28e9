// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace echomap::bench {

/// One measured figure; `peers` hold the same figure of others, measured in the same run.
struct Figure {
  std::string name;
  double value = 0.0;
  std::string unit;
  std::size_t runs = 0;
  std::map<std::string, double> peers;
};

/// What is said of the figures in words, by name: the emulator of each board.
using Notes = std::map<std::string, std::string>;

/// Prints a table on stdout, below the processor and the instruction set that this was compiled
/// for, and writes {"cpu": .., "isa": .., "figures": [..], "notes": {..}} to `json` unless it is
/// empty; without notes there are none in either. Throws files::FileError.
void report(const std::vector<Figure>& figures,
            const std::filesystem::path& json,
            const Notes& notes = {});

}  // namespace echomap::bench

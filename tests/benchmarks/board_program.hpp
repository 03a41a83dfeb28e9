// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tests/benchmarks/board_table.hpp"
#include "tests/benchmarks/measured_boards.hpp"

namespace echomap::bench {

/// Starts the program that measures over `board`'s emulator and waits for its figures; `part` is
/// "link" or "table". Throws std::runtime_error where something is not built or the program fails.
BoardReport run_measures(const MeasuredBoard& board,
                         const std::string& part,
                         const BuildFolders& folders);

}  // namespace echomap::bench

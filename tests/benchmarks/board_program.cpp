// SPDX-License-Identifier: MIT
#include "tests/benchmarks/board_program.hpp"

#include <chrono>
#include <stdexcept>

#include "host/files/atomic_file.hpp"
#include "host/session/child_process.hpp"
#include "host/session/temporary_folder.hpp"

namespace echomap::bench {
namespace {

/// Of an emulator that is slower than its board, for minutes of simulated time.
constexpr std::chrono::minutes kMeasurePatience(60);

}  // namespace

BoardReport run_measures(const MeasuredBoard& board,
                         const std::string& part,
                         const BuildFolders& folders) {
  const std::string missing = missing_of(board, board.measures, folders);
  if (!missing.empty()) {
    throw std::runtime_error(board.name + ": " + missing + " is not built");
  }
  const session::TemporaryFolder folder;
  const auto json = folder / "figures.json";
  const auto log = folder / "log";
  session::ChildProcess program({folders.programs / board.measures,
                                 "--board=" + board.name,
                                 "--part=" + part,
                                 "--json=" + json.string()},
                                log);
  if (program.wait_for(kMeasurePatience) != 0) {
    throw std::runtime_error(board.measures + " failed: " + files::read_text_file(log));
  }
  return read_board_report(files::read_text_file(json), board.name);
}

}  // namespace echomap::bench

// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <spdlog/spdlog.h>

#include "host/apps/commands.hpp"
#include "host/apps/played_history.hpp"
#include "host/apps/served_page.hpp"
#include "host/console/print.hpp"

namespace echomap::apps {

ExitCode run_serve(const ServeOptions& options) {
  std::vector<live_page::ServedRun> runs;
  for (const std::filesystem::path& run : options.runs) {
    console::print("reading " + run.string());
    runs.push_back(played_run(run, std::to_string(runs.size())));
  }
  const auto server = serve_page(options.live, std::move(runs));
  console::print("Ctrl-C ends it");
  wait_for_interrupt();
  return ExitCode::kOk;
}

}  // namespace echomap::apps

// SPDX-License-Identifier: MIT
#include <filesystem>

#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/report.hpp"
#include "host/evaluation/run_score.hpp"

namespace echomap::apps {

ExitCode run_eval(const EvalOptions& options) {
  const auto score = evaluation::score_run(options.run, options.truth);
  print_score(score);
  write_report(options.json, to_json(score));
  return ExitCode::kOk;
}

}  // namespace echomap::apps

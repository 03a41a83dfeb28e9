// SPDX-License-Identifier: MIT
#include "host/apps/run_words.hpp"

#include <string>

#include <fmt/format.h>

namespace echomap::apps {

console::CommandWords strategy_words(const RunOptions& run) {
  const RunOptions usual;
  console::CommandWords words;
  const auto say = [&words](bool is_asked_for, const char* option, const std::string& value) {
    if (is_asked_for) {
      words.insert(words.end(), {option, value});
    }
  };
  const strategies::StrategyOptions& strategy = run.strategy;
  say(strategy.name != usual.strategy.name, "--strategy", strategy.name);
  say(!strategy.waypoints.empty(), "--waypoints", strategy.waypoints);
  say(!strategy.stop_list.empty(), "--stop-list", strategy.stop_list);
  say(strategy.scans != usual.strategy.scans, "--scans", std::to_string(strategy.scans));
  say(strategy.hand != usual.strategy.hand, "--hand", strategy.hand);
  say(strategy.seconds != usual.strategy.seconds, "--seconds", fmt::format("{}", strategy.seconds));
  if (strategy.as_told) {
    words.emplace_back("--as-told");
  }
  say(run.slam != usual.slam, "--slam", run.slam);
  return words;
}

console::CommandWords robot_words(const RunOptions& run) {
  return run.robot == RunOptions().robot ? console::CommandWords{}
                                         : console::CommandWords{"--robot", run.robot};
}

}  // namespace echomap::apps

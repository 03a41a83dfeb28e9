// SPDX-License-Identifier: MIT
#include "host/apps/live_options.hpp"

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

namespace echomap::apps {

void add_live_options(CLI::App& command, LiveOptions& options, bool is_asked_for) {
  if (is_asked_for) {
    command.add_flag("--live", options.serves, "Show the run in a browser (docs/guides/live.md)");
  }
  command
      .add_option("--listen",
                  options.listen,
                  "Address, or ADDRESS:PORT, of the live page. Others than this machine get in by "
                  "the token of the printed URL")
      ->capture_default_str();
  command.add_flag("!--no-browser", options.opens_browser, "Print the page's URL, open nothing");
}

CLI::Option* add_speed_option(CLI::App& command, double& factor) {
  return command
      .add_option("--speed",
                  factor,
                  "Simulated time, times real time, or max; by default 8 where somebody may watch")
      ->transform(CLI::Validator(
          [](std::string& text) {
            if (text == "max") {
              text = "0";
            }
            return std::string();
          },
          "NUMBER|max"))
      ->check(CLI::Range(0.0, 1000.0))
      ->check([](const std::string& text) {
        return std::isnan(std::strtod(text.c_str(), nullptr)) ? "'" + text + "' is no number"
                                                              : std::string();
      });
}

void add_serve(CLI::App& app, CommandAction& action) {
  CLI::App* command = app.add_subcommand("serve", "Show finished runs in a browser");
  const auto options = std::make_shared<ServeOptions>();
  command->add_option("runs", options->runs, "Run directories or recordings (session.mcap)")
      ->required()
      ->check(CLI::ExistingPath);
  add_live_options(*command, options->live, false);
  command->footer("Example: echomap serve first_map kitchen");
  command->callback([&action, options] { action = [options] { return run_serve(*options); }; });
}

}  // namespace echomap::apps

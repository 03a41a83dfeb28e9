// SPDX-License-Identifier: MIT
#include "host/apps/port_options.hpp"

#include <memory>

#include <CLI/CLI.hpp>

#include "host/apps/commands.hpp"

namespace echomap::apps {

void add_ports(CLI::App& app, CommandAction& action) {
  CLI::App* command =
      app.add_subcommand("ports", "List the serial ports at which a robot may be; opens none");
  const auto options = std::make_shared<PortsOptions>();
  command->add_option("--json", options->json, "Write the list to this file, '-' for stdout");
  CLI::Option* forget =
      command->add_option("--forget",
                          options->forget,
                          "Forget that a robot has answered at this port; it is asked for again");
  CLI::Option* forget_all = command->add_flag(
      "--forget-all", options->forget_all, "Forget every port at which a robot has answered");
  CLI::Option* print =
      command->add_flag("--print-rules",
                        options->print_rules,
                        "Print udev rules: no ModemManager, group dialout, a lasting name");
  command
      ->add_flag("--install-rules",
                 options->install_rules,
                 "Write these rules to /etc/udev/rules.d/60-echomap.rules; needs sudo")
      ->excludes(print);
  forget->excludes(forget_all);
  command->footer("Example: sudo echomap ports --install-rules");
  command->callback([&action, options] { action = [options] { return run_ports(*options); }; });
}

}  // namespace echomap::apps

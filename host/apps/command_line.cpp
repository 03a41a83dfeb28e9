// SPDX-License-Identifier: MIT
#include "host/apps/command_line.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/fleet_options.hpp"
#include "host/apps/live_options.hpp"
#include "host/apps/localize_options.hpp"
#include "host/apps/map_options.hpp"
#include "host/apps/paper_options.hpp"
#include "host/apps/port_options.hpp"
#include "host/apps/robot_options.hpp"
#include "host/apps/search_options.hpp"
#include "host/console/interrupt.hpp"
#include "host/console/log_sink.hpp"
#include "host/files/nearest_word.hpp"
#include "host/files/toml_reader.hpp"
#include "host/transport/transport_error.hpp"

namespace echomap::apps {
namespace {

using console::CommandError;
using console::ExitCode;

constexpr const char* kExitCodes =
    "Exit codes:\n"
    "  0    what was asked for is there\n"
    "  1    runtime error\n"
    "  2    wrong usage\n"
    "  3    no robot, or more than one\n"
    "  4    the firmware is of another version\n"
    "  5    the link to the robot is lost\n"
    "  6    a configuration is invalid\n"
    "  7    safety stop: stuck, lifted, battery low, a wheel out of control\n"
    "  8    ended, but unfinished: what is missing is said\n"
    "  9    the robot is not as its profile says: what to change is said\n"
    "  130  interrupted";

void set_up_logging(bool verbose, bool quiet) {
  auto logger =
      std::make_shared<spdlog::logger>("echomap", std::make_shared<console::LogSink>(stderr));
  logger->set_pattern("echomap: %^%l%$: %v");
  logger->set_level(verbose ? spdlog::level::debug
                            : (quiet ? spdlog::level::err : spdlog::level::info));
  spdlog::set_default_logger(std::move(logger));
}

/// How far the arguments name sub-commands.
struct NamedCommand {
  const CLI::App* app = nullptr;
  std::string words;    ///< "echomap", or with the sub-commands behind it.
  std::string unknown;  ///< The word where a sub-command is due and none has that name.
};

NamedCommand named_command(const CLI::App& app, int argc, char** argv) {
  NamedCommand named{&app, app.get_name(), ""};
  for (const std::string& word : std::vector<std::string>(argv + 1, argv + argc)) {
    if (word.starts_with('-')) {
      continue;
    }
    const auto commands = named.app->get_subcommands({});
    const auto command =
        std::ranges::find_if(commands, [&](const CLI::App* one) { return one->check_name(word); });
    if (command == commands.end()) {
      named.unknown = commands.empty() ? "" : word;
      break;
    }
    named.app = *command;
    named.words += " " + word;
  }
  return named;
}

/// CLI11 says only that some sub-command is needed; say which one was meant.
ExitCode report_usage(const CLI::App& app,
                      const CLI::ParseError& error,
                      const NamedCommand& named) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    app.exit(error);
    return ExitCode::kOk;
  }
  std::vector<std::string> names;
  for (const CLI::App* command : named.app->get_subcommands({})) {
    names.push_back(command->get_name());
    names.insert(names.end(), command->get_aliases().begin(), command->get_aliases().end());
  }
  const std::string what = named.unknown.empty() ? error.what()
                                                 : "unknown command '" + named.unknown + "'" +
                                                       files::suggestion(named.unknown, names);
  std::fputs(("echomap: " + what + "\n  next: " + named.words + " --help\n").c_str(), stderr);
  return ExitCode::kUsage;
}

ExitCode run_and_report(const CommandAction& action) {
  const auto fail = [](ExitCode code, const char* message) {
    spdlog::error("{}", message);
    return code;
  };
  try {
    return action();
  } catch (const CommandError& error) {
    return fail(error.code(), error.what());
  } catch (const files::ConfigError& error) {
    return fail(ExitCode::kConfigInvalid, error.what());
  } catch (const transport::TransportError& error) {
    return fail(ExitCode::kNoRobot, error.what());
  } catch (const std::exception& error) {
    return fail(ExitCode::kRuntimeError, error.what());
  }
}

}  // namespace

ExitCode run_command_line(int argc, char** argv) {
  CLI::App app("echomap: map a room and localize in it with a cheap robot", "echomap");
  app.set_version_flag("--version", "echomap " ECHOMAP_VERSION);
  app.require_subcommand(1);
  app.footer(kExitCodes);
  bool verbose = false;
  bool quiet = false;
  app.add_flag("-v,--verbose", verbose, "Print debug messages on stderr");
  app.add_flag("-q,--quiet", quiet, "Print errors only");
  app.fallthrough();
  CommandAction action;
  add_demo(app, action);
  add_explore(app, action);
  add_search(app, action);
  add_eval(app, action);
  add_replay(app, action);
  add_export(app, action);
  add_serve(app, action);
  add_localize(app, action);
  add_diff(app, action);
  add_characterise(app, action);
  add_flash(app, action);
  add_ports(app, action);
  add_paper(app, action);
  add_fleet(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report_usage(app, error, named_command(app, argc, argv));
  }
  set_up_logging(verbose, quiet);
  console::catch_interrupts();
  return run_and_report(action);
}

}  // namespace echomap::apps

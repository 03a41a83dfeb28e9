// SPDX-License-Identifier: MIT
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/apps/commands.hpp"
#include "host/broker/broker.hpp"
#include "host/broker/credentials.hpp"
#include "host/console/interrupt.hpp"
#include "host/console/print.hpp"
#include "host/console/shell_line.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHub = "hub";
constexpr const char* kObserver = "watch";

/// The account of that name that the folder has from an earlier start, so that a robot keeps its
/// file; a new one where there is none.
broker::BrokerUser account(const fs::path& members, const std::string& name) {
  const fs::path file = members / (name + ".toml");
  return {name, exists(file) ? broker::read_credentials(file).password : broker::random_password()};
}

broker::SiteBridge bridge_as(const fs::path& file) {
  const broker::Credentials site = broker::read_credentials(file);
  const fs::path ca_file = site.ca_file.empty() ? fs::path() : fs::absolute(site.ca_file);
  return {site.host, site.port, site.fleet, site.user, site.password, ca_file};
}

/// What robots' hosts have for this machine. Throws CommandError kUsage where nobody has named it.
std::vector<std::string> host_names(const FleetBrokerOptions& options) {
  if (!options.host_names.empty()) {
    return options.host_names;
  }
  if (broker::is_unspecified(options.address)) {
    throw CommandError(ExitCode::kUsage,
                       "robots' hosts need a name or an address of this machine to connect to\n"
                       "  next: add --name, such as --name 192.168.1.7 (hostname -I lists them)");
  }
  return {options.address};
}

broker::BrokerSettings broker_settings(const FleetBrokerOptions& options) {
  broker::BrokerSettings settings;
  settings.fleet = options.fleet;
  settings.address = options.address;
  settings.port = options.port;
  settings.hub = kHub;
  settings.tls = true;
  settings.host_names = host_names(options);
  for (const std::string& robot : options.robots) {
    if (robot == kHub || robot == kObserver) {
      throw CommandError(ExitCode::kUsage,
                         fmt::format("--robots {}: 'hub' and 'watch' are accounts of the broker's "
                                     "own\n  next: name the robot otherwise",
                                     robot));
    }
    settings.users.push_back({robot, ""});
  }
  settings.users.push_back({kHub, ""});
  settings.users.push_back({kObserver, ""});
  for (broker::BrokerUser& user : settings.users) {
    user = account(options.out / "members", user.name);
  }
  if (!options.bridge_as.empty()) {
    settings.bridge = bridge_as(options.bridge_as);
  }
  return settings;
}

void refuse_another_folder(const fs::path& folder) {
  const bool is_a_brokers = exists(folder / "rights.acl") || exists(folder / "tls");
  if (exists(folder) && !is_a_brokers && !fs::is_empty(folder)) {
    throw CommandError(
        ExitCode::kUsage,
        folder.string() + " has other files, and none of a broker\n  next: name a new folder");
  }
}

void print_how_to_join(const broker::Broker& broker, const FleetBrokerOptions& options) {
  const fs::path members = broker.folder() / "members";
  console::print(fmt::format("broker of the fleet '{}' on {}, port {}, TLS; Ctrl-C ends it",
                             options.fleet,
                             options.address,
                             broker.port()));
  for (const std::string& robot : options.robots) {
    console::print(
        fmt::format("{}: copy {} and {} to its host, then: {}",
                    robot,
                    broker.credentials_file(robot).string(),
                    (members / "ca.crt").string(),
                    console::shell_line({"echomap", "fleet", "join", "--as", robot + ".toml"})));
  }
  console::print(
      "observe it with: " +
      console::shell_line(
          {"echomap", "fleet", "status", "--as", broker.credentials_file(kObserver).string()}));
}

}  // namespace

ExitCode run_fleet_broker(const FleetBrokerOptions& options) {
  refuse_another_folder(options.out);
  broker::Broker broker(broker_settings(options), options.out);
  print_how_to_join(broker, options);
  while (!console::interrupted()) {
    if (!broker.is_running()) {
      throw CommandError(
          ExitCode::kRuntimeError,
          "the broker has ended\n  next: see " + (broker.folder() / "mosquitto.log").string());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  broker.stop();
  console::print("the broker has ended; what was retained is in " +
                 (broker.folder() / "store").string() +
                 "\n  next: the same command starts it again, with the same accounts");
  return ExitCode::kOk;
}

}  // namespace echomap::apps

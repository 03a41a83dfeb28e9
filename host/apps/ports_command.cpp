// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/commands.hpp"
#include "host/apps/report.hpp"
#include "host/console/print.hpp"
#include "host/files/atomic_file.hpp"
#include "host/session/child_process.hpp"
#include "host/session/known_ports.hpp"
#include "host/session/port_choice.hpp"
#include "host/transport/port_holder.hpp"
#include "host/transport/udev_rules.hpp"
#include "host/transport/usb_table.hpp"

namespace echomap::apps {
namespace {

using session::KnownPorts;
using transport::PortHolder;
using transport::PortInfo;

/// What the list says of one port.
struct ListedPort {
  PortInfo port;
  bool is_possible = false;  ///< A robot may be there.
  bool is_known = false;     ///< A robot has answered there before.
  std::vector<PortHolder> holders;
};

std::vector<ListedPort> listed_ports(const std::vector<PortInfo>& ports, const KnownPorts& known) {
  std::vector<ListedPort> list;
  for (const PortInfo& port : ports) {
    const bool is_known = known.has(port);
    const bool has_id_of_board = port.usb_id && transport::may_be_robot(*port.usb_id);
    auto holders = transport::port_holders(port.name);
    if (auto by_file = transport::lock_file_holder(port.name)) {
      holders.push_back(std::move(*by_file));
    }
    list.push_back({port, is_known || has_id_of_board, is_known, std::move(holders)});
  }
  return list;
}

std::string what_is(const PortInfo& port) {
  const auto* known = port.usb_id ? transport::known_usb_id(*port.usb_id) : nullptr;
  return known != nullptr ? std::string(known->what) : port.description;
}

std::string device_line(const PortInfo& port) {
  std::string line = port.name;
  if (port.usb_id) {
    line += "  " + to_string(*port.usb_id);
  }
  line += "  " + what_is(port);
  if (!port.serial_number.empty()) {
    line += ", serial number " + port.serial_number;
  }
  return port.usb_path.empty() ? line : line + ", socket " + port.usb_path;
}

std::string state_line(const ListedPort& listed) {
  std::string line = "    ";
  if (listed.is_known) {
    line += "a robot answered here before";
  } else {
    line += listed.is_possible
                ? "may be a robot: the first time, name it with --port " + listed.port.name
                : "left alone: it has no USB id of a board that echomap knows";
  }
  for (const PortHolder& holder : listed.holders) {
    line += "\n    in use by " + in_words(holder) +
            "\n      next: " + remedy_against(holder, listed.port.name);
  }
  return line;
}

void print_list(const std::vector<ListedPort>& list, const KnownPorts& known) {
  for (const ListedPort& listed : list) {
    console::print(device_line(listed.port) + "\n" + state_line(listed));
  }
  for (const PortInfo& port : known.ports()) {
    const bool is_here = std::ranges::any_of(
        list, [&](const ListedPort& listed) { return is_same_device(listed.port, port); });
    if (!is_here) {
      console::print(device_line(port) + "\n    a robot answered here before; not plugged in now");
    }
  }
  if (list.empty()) {
    console::print(transport::describe_ports({}) +
                   "\n  next: plug the robot in, or try without one: echomap demo");
  }
}

nlohmann::ordered_json json_of(const ListedPort& listed) {
  const PortInfo& port = listed.port;
  nlohmann::ordered_json json{{"name", port.name},
                              {"usb_id", port.usb_id ? to_string(*port.usb_id) : ""},
                              {"what", what_is(port)},
                              {"serial_number", port.serial_number},
                              {"usb_path", port.usb_path},
                              {"may_be_robot", listed.is_possible},
                              {"robot_answered_before", listed.is_known},
                              {"held_by", nlohmann::ordered_json::array()}};
  for (const PortHolder& holder : listed.holders) {
    json["held_by"].push_back({{"pid", holder.pid}, {"command", holder.command}});
  }
  return json;
}

void forget(const std::string& name, const std::vector<PortInfo>& here, KnownPorts& known) {
  std::vector<PortInfo> named;
  for (const auto* ports : {&here, &known.ports()}) {
    std::ranges::copy_if(*ports, std::back_inserter(named), [&](const PortInfo& port) {
      return port.name == name && known.has(port);
    });
  }
  if (named.empty()) {
    throw CommandError(ExitCode::kUsage,
                       "no robot has answered at " + name +
                           ", as far as is remembered\n  next: echomap ports lists where");
  }
  known.forget(named.front());
}

void install_rules(const std::filesystem::path& folder) {
  const auto file = folder / transport::kUdevRulesName;
  try {
    files::write_text_file(file, transport::udev_rules());
  } catch (const files::FileError& error) {
    throw CommandError(ExitCode::kRuntimeError,
                       fmt::format("{}\n  next: sudo {} ports --install-rules",
                                   error.what(),
                                   (session::program_folder() / "echomap").string()));
  }
  console::print("written: " + file.string() + "\n  next: unplug the robot and plug it in again");
}

}  // namespace

ExitCode run_ports(const PortsOptions& options) {
  if (options.print_rules) {
    fmt::print("{}", transport::udev_rules());
    return ExitCode::kOk;
  }
  if (options.install_rules) {
    install_rules(options.rules_folder);
    return ExitCode::kOk;
  }
  const auto ports = transport::list_ports(options.sysfs);
  KnownPorts known;
  if (options.forget_all) {
    known.forget_all();
  }
  if (!known.trouble().empty()) {
    spdlog::warn("{}", known.trouble());
  }
  if (!options.forget.empty()) {
    forget(options.forget, ports, known);
  }
  const auto list = listed_ports(ports, known);
  print_list(list, known);
  nlohmann::ordered_json report{{"ports", nlohmann::ordered_json::array()}};
  for (const ListedPort& listed : list) {
    report["ports"].push_back(json_of(listed));
  }
  write_report(options.json, report);
  return ExitCode::kOk;
}

}  // namespace echomap::apps

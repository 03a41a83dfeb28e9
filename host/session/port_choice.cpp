// SPDX-License-Identifier: MIT
#include "host/session/port_choice.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "host/console/exit_code.hpp"
#include "host/console/question.hpp"
#include "host/robot_link/robot_probe.hpp"
#include "host/session/known_ports.hpp"
#include "host/session/speed_search.hpp"
#include "host/transport/port_holder.hpp"
#include "host/transport/transport_error.hpp"
#include "host/transport/usb_devices.hpp"
#include "host/transport/usb_table.hpp"

namespace echomap::session {
namespace {

using std::chrono::steady_clock;
using transport::PortInfo;

constexpr std::chrono::milliseconds kAnswerPatience{2500};
constexpr std::chrono::milliseconds kReplyPatience{200};
constexpr std::chrono::milliseconds kTurn{5};

struct Candidate {
  std::string port;
  robot_link::RobotProbe probe;
  std::unique_ptr<transport::ByteStream> stream;  ///< Null where it cannot be opened.
  std::string failure;                            ///< Why not, and what to do about it.
};

Candidate ask(const std::string& port, const OpenPort& open, std::uint16_t session) {
  Candidate candidate{port, robot_link::RobotProbe(session), nullptr, ""};
  try {
    candidate.stream = open(port);
    candidate.stream->write(candidate.probe.hello());
  } catch (const transport::TransportError& error) {
    candidate.failure = error.why() + "\n    next: " + error.next_step();
  }
  return candidate;
}

bool is_robot(const Candidate& candidate) { return candidate.probe.robot().has_value(); }

/// Another program's robot: it answers a Hello with that one's session.
bool is_busy(const Candidate& candidate) {
  const auto& robot = candidate.probe.robot();
  return robot && candidate.probe.is_foreign(robot->session);
}

bool may_answer(const Candidate& candidate) {
  return candidate.stream && candidate.stream->status() == transport::StreamStatus::kOpen &&
         !is_robot(candidate);
}

void listen(std::vector<Candidate>& candidates, std::chrono::milliseconds patience) {
  std::array<std::uint8_t, 4096> buffer{};
  const auto until = steady_clock::now() + patience;
  while (steady_clock::now() < until &&
         std::any_of(candidates.begin(), candidates.end(), may_answer)) {
    for (Candidate& candidate : candidates) {
      if (candidate.stream) {
        const std::size_t count = candidate.stream->read_some(buffer, kTurn);
        candidate.probe.receive(std::span(buffer).first(count));
      }
    }
  }
}

/// Where nobody gave a speed, those that are silent may be of an older image.
void ask_at_other_speeds(std::vector<Candidate>& candidates) {
  for (const int baud : kRobotBauds) {
    bool is_changed = false;
    for (Candidate& candidate : candidates) {
      if (may_answer(candidate) && baud != kRobotBauds.front() &&
          candidate.stream->set_baud(baud)) {
        candidate.stream->write(candidate.probe.hello());
        is_changed = true;
      }
    }
    if (is_changed) {
      listen(candidates, kReplyPatience);
    }
  }
}

std::string said_by(const Candidate& candidate) {
  if (!candidate.stream) {
    return candidate.failure;
  }
  if (const auto& robot = candidate.probe.robot()) {
    return fmt::format("a robot, boot {:04x}", robot->boot_id) +
           (is_busy(candidate) ? ", busy: another program holds it" : "");
  }
  const std::string preview = candidate.probe.preview().text();
  return preview.empty() ? "silent" : "no robot; what came from it:\n" + preview;
}

[[noreturn]] void refuse(const std::vector<Candidate>& candidates, const std::string& what) {
  std::string text = what + ":\n";
  for (const Candidate& candidate : candidates) {
    text += "  " + candidate.port + ": " + said_by(candidate) + "\n";
  }
  throw console::CommandError(console::ExitCode::kNoRobot, text + "  next: name one with --port");
}

std::string port_with_id(std::string_view id, const std::vector<PortInfo>& ports) {
  const auto fitting = transport::ports_with_id(ports, id);
  if (fitting.size() != 1) {
    throw console::CommandError(
        console::ExitCode::kNoRobot,
        fmt::format("{} ports fit 'id:{}'; {}\n  next: name one with --port",
                    fitting.empty() ? "no" : "several",
                    id,
                    transport::describe_ports(ports)));
  }
  return fitting.front().name;
}

/// "/dev/ttyUSB0: CH340 (1a86:7523), a robot answered here before, in use by another program".
std::string line_of(const PortInfo& port, const PortSurroundings& here) {
  const auto* known = port.usb_id ? transport::known_usb_id(*port.usb_id) : nullptr;
  std::string line = port.name + ": " + (known ? std::string(known->what) : port.description);
  if (port.usb_id) {
    line += " (" + to_string(*port.usb_id) + ")";
  }
  line += here.is_known(port) ? ", a robot answered here before" : "";
  return line + (here.is_held(port) ? ", in use by another program" : "");
}

[[noreturn]] void end_without_choice(const std::string& text) {
  throw console::CommandError(console::ExitCode::kNoRobot, text);
}

std::string confirmed(const PortInfo& port, const PortSurroundings& here) {
  const std::string what =
      line_of(port, here) + "\nNo robot has answered there yet: many devices have such a chip.";
  const auto answer = here.ask(what + "\nIs it the robot? (yes or no)");
  if (!answer || (*answer != "yes" && *answer != "y" && *answer != "Yes" && *answer != "Y")) {
    end_without_choice((answer ? "no port was chosen" : what) +
                       "\n  next: name the robot's port, once: --port " + port.name);
  }
  return port.name;
}

std::string chosen_from(const std::vector<PortInfo>& ports, const PortSurroundings& here) {
  std::string list = "the robot may be at any of these ports:\n";
  for (std::size_t i = 0; i < ports.size(); ++i) {
    list += fmt::format("  {}  {}\n", i + 1, line_of(ports[i], here));
  }
  const auto answer_to = [&here](const std::string& question) {
    return here.ask(question).value_or("");
  };
  auto answer = answer_to(fmt::format("{}Which one? (1 to {})", list, ports.size()));
  while (!answer.empty()) {
    std::size_t number = 0;
    std::from_chars(answer.data(), answer.data() + answer.size(), number);
    if (number >= 1 && number <= ports.size()) {
      return ports[number - 1].name;
    }
    answer = answer_to(fmt::format("A number from 1 to {}, or Enter for none:", ports.size()));
  }
  end_without_choice(list + "  next: name one, as in --port " + ports.front().name);
}

/// brltty takes a CH340 or CP2102 so early that no /dev/ttyUSB is there.
std::string why_no_port(const std::vector<PortInfo>& ports) {
  for (const auto& device : transport::list_usb_devices()) {
    const bool has_port =
        std::ranges::find(ports, std::optional(device.id), &PortInfo::usb_id) != ports.end();
    const auto* known = transport::known_usb_id(device.id);
    if (has_port || known == nullptr || known->role == transport::UsbRole::kProgrammer) {
      continue;
    }
    const std::string what = fmt::format("{} ({})", known->what, to_string(device.id));
    if (known->role == transport::UsbRole::kBootDrive) {
      return what +
             " is a drive that waits for its program, not a port\n  next: copy a program "
             "to it, or replug it without holding BOOTSEL";
    }
    if (const auto brltty = transport::process_named("brltty")) {
      return what + " has no port: " + in_words(*brltty) +
             " has probably taken it\n  next: " + remedy_against(*brltty, "");
    }
  }
  return "";
}

}  // namespace

PortSurroundings surroundings_here() {
  const auto known = std::make_shared<KnownPorts>();
  if (!known->trouble().empty()) {
    spdlog::warn("{}", known->trouble());
  }
  auto ports = transport::list_ports();
  std::string why_none = why_no_port(ports);
  return {std::move(ports),
          [known](const PortInfo& port) { return known->has(port); },
          [](const PortInfo& port) { return !transport::port_holders(port.name).empty(); },
          console::ask,
          std::move(why_none)};
}

std::vector<PortInfo> possible_robots(const PortSurroundings& here) {
  std::vector<PortInfo> possible;
  std::ranges::copy_if(here.ports, std::back_inserter(possible), [&](const PortInfo& port) {
    return (port.usb_id && transport::may_be_robot(*port.usb_id)) || here.is_known(port);
  });
  return possible;
}

std::string choose_possible_robot(const PortSurroundings& here) {
  const auto possible = possible_robots(here);
  if (possible.empty()) {
    end_without_choice("no serial port here can be a robot; " +
                       transport::describe_ports(here.ports) + "\n  " +
                       (here.why_none.empty() ? "next: plug the robot in, name its port with "
                                                "--port, or try without one: echomap demo"
                                              : here.why_none));
  }
  std::vector<PortInfo> known;
  std::ranges::copy_if(possible, std::back_inserter(known), here.is_known);
  if (known.size() > 1) {
    std::erase_if(known, here.is_held);
  }
  if (known.size() == 1 && (possible.size() == 1 || !here.is_held(known.front()))) {
    spdlog::info("using {}", line_of(known.front(), here));
    return known.front().name;
  }
  return possible.size() == 1 ? confirmed(possible.front(), here) : chosen_from(possible, here);
}

std::vector<std::string> candidate_ports(const std::vector<std::string>& named,
                                         const PortSurroundings& here) {
  if (named.empty()) {
    return {choose_possible_robot(here)};
  }
  std::vector<std::string> ports;
  for (const std::string& name : named) {
    const auto id = transport::port_id_text(name);
    ports.push_back(id ? port_with_id(*id, here.ports) : name);
  }
  return ports;
}

std::unique_ptr<transport::ByteStream> choose_port(const std::vector<std::string>& ports,
                                                   const OpenPort& open,
                                                   std::uint16_t session,
                                                   bool at_any_speed) {
  if (ports.size() == 1) {
    return open(ports.front());
  }
  std::vector<Candidate> asked;
  asked.reserve(ports.size());
  for (const std::string& port : ports) {
    asked.push_back(ask(port, open, session));
  }
  listen(asked, kAnswerPatience);
  if (at_any_speed && std::none_of(asked.begin(), asked.end(), is_robot)) {
    ask_at_other_speeds(asked);
  }
  const auto is_free = [](const Candidate& one) { return is_robot(one) && !is_busy(one); };
  const bool any_free = std::any_of(asked.begin(), asked.end(), is_free);
  const auto fits = [&](const Candidate& one) { return any_free ? is_free(one) : is_robot(one); };
  const auto robots = std::count_if(asked.begin(), asked.end(), fits);
  if (robots != 1) {
    refuse(asked, robots == 0 ? "no robot answers" : "more than one robot answers");
  }
  return std::move(std::find_if(asked.begin(), asked.end(), fits)->stream);
}

}  // namespace echomap::session

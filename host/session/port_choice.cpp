// SPDX-License-Identifier: MIT
#include "host/session/port_choice.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "host/console/exit_code.hpp"
#include "host/robot_link/robot_probe.hpp"
#include "host/transport/port_list.hpp"
#include "host/transport/transport_error.hpp"

namespace echomap::session {
namespace {

using std::chrono::steady_clock;

constexpr std::chrono::milliseconds kAnswerPatience{2500};
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

void listen(std::vector<Candidate>& candidates) {
  std::array<std::uint8_t, 4096> buffer{};
  const auto until = steady_clock::now() + kAnswerPatience;
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

std::string port_with_id(std::string_view id) {
  const auto ports = transport::list_ports();
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

}  // namespace

CandidatePorts candidate_ports(const std::vector<std::string>& named) {
  CandidatePorts candidates{{}, !named.empty()};
  for (const std::string& name : named) {
    const auto id = transport::port_id_text(name);
    candidates.ports.push_back(id ? port_with_id(*id) : name);
  }
  if (named.empty()) {
    for (const auto& port : transport::list_ports()) {
      candidates.ports.push_back(port.name);
    }
  }
  return candidates;
}

std::unique_ptr<transport::ByteStream> choose_port(const CandidatePorts& candidates,
                                                   const OpenPort& open,
                                                   std::uint16_t session) {
  if (candidates.ports.empty()) {
    throw console::CommandError(console::ExitCode::kNoRobot,
                                "no USB or Bluetooth serial port is here\n  next: plug the robot "
                                "in, or try without one: echomap demo");
  }
  if (candidates.are_named && candidates.ports.size() == 1) {
    return open(candidates.ports.front());
  }
  std::vector<Candidate> asked;
  asked.reserve(candidates.ports.size());
  for (const std::string& port : candidates.ports) {
    asked.push_back(ask(port, open, session));
  }
  listen(asked);
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

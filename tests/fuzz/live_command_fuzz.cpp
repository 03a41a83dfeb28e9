// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <string_view>
#include <variant>

#include <nlohmann/json.hpp>

#include "host/live_page/command_handler.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace {

namespace live_page = echomap::live_page;
namespace session = echomap::session;
using echomap::fuzz::require;

constexpr double kMaxPlaceM = 1e4;

bool is_place(const Eigen::Vector2d& at_m) { return at_m.cwiseAbs().maxCoeff() <= kMaxPlaceM; }

/// What reaches a session is within the limits that the document tells.
struct RequireLimits {
  void operator()(const session::SteerRobot& steer) const {
    require(std::abs(steer.forward) <= 1.0 && std::abs(steer.turn) <= 1.0, "steering is a share");
  }
  void operator()(const session::GoTo& go) const { require(is_place(go.at_m), "a goal is near"); }
  void operator()(const session::PutBox& box) const {
    require(is_place(box.at_m), "a box is near");
  }
  void operator()(const session::PlaceRobot& place) const {
    require(is_place(place.T_map_robot.position_m()), "a pose is near");
    require(std::isfinite(place.T_map_robot.heading_rad()), "a heading is one");
  }
  void operator()(const session::SetSpeed& speed) const {
    require(speed.factor == 0.0 || (speed.factor >= 0.1 && speed.factor <= 100.0),
            "a speed is one");
  }
  void operator()(const session::CutCable& cut) const {
    require(cut.for_s >= 0.0 && cut.for_s <= 60.0, "a cable is not cut for good");
  }
  template <typename Other>
  void operator()(const Other&) const {}
};

void check_answer(const live_page::CommandHandler::Answer& answer) {
  const auto json = nlohmann::json::parse(answer.text, nullptr, false);
  require(json.is_object() && json.contains("ack") && json["ok"].is_boolean(), "an answer is one");
  require(json["ok"] == !answer.refused.has_value(), "an answer says what was done");
  require(!answer.refused || !answer.command, "what is refused is not done");
  if (answer.command) {
    std::visit(RequireLimits(), *answer.command);
  }
}

bool is_steered(const live_page::CommandHandler::Answer& answer) {
  return answer.command && std::holds_alternative<session::SteerRobot>(*answer.command);
}

/// By the first letter of what it says.
std::uint64_t client_of(std::string_view text) {
  return text.empty() ? 0U : static_cast<unsigned char>(text[0]) % 4U;
}

void close_client(live_page::CommandHandler& handler, std::uint64_t client) {
  const auto before = handler.driver();
  const bool drove = before && before->client == client;
  require(handler.close(client).has_value() == drove, "a driver that is gone stops the robot");
  require(!drove || !handler.driver(), "a client that is gone does not drive");
}

void take_command(live_page::CommandHandler& handler, std::uint64_t client, std::string_view text) {
  const auto before = handler.driver();
  const auto answer = handler.answer(client, text);
  check_answer(answer);
  require(!is_steered(answer) || !before || before->client == client, "one client drives");
  require(!is_steered(answer) || handler.driver()->client == client, "who steers has the lock");
}

}  // namespace

std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  return {
      input_of(R"(1{"do": "drive", "seq": 1, "forward": 0.5, "turn": -1, "seen": 1000}
2{"do": "drive", "seq": 1, "forward": 0.5, "turn": -1, "seen": 1000}
2{"do": "stop", "seq": 2}
1{"do": "drive", "seq": 2, "forward": 0.5, "turn": 0, "seen": 1000}
1{"do": "drive", "seq": 3, "forward": 0, "turn": 0, "seen": 1000}
1{"do": "release", "seq": 4})"),
      input_of(R"(1{"do": "name", "name": "ph\u001b\u00fcne", "seq": 9007199254740992}
1{"do": "ping"}
t
1{"do": "go", "x": 1.5, "y": -2}
1{"do": "pose", "x": 1, "y": 2, "heading": 7}
1{"do": "explore"}
x1)"),
      input_of(R"(1{"do": "speed", "factor": 8}
1{"do": "box", "x": 0, "y": 9999}
1{"do": "cut-cable", "seconds": 4}
1{"do": "carry-off"}
1{"do": "moved", "seq": -1}
1{"do": "fly"}
1[1, 2])"),
  };
}

/// One input is lines: of a client, by its digit; "t": half a second goes by; "x": a client closes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  double now_ms = 1000.0;
  live_page::CommandHandler handler(
      std::vector<std::string>{
          "drive", "go", "explore", "moved", "pose", "speed", "box", "cut-cable"},
      [&now_ms] { return now_ms; });
  const std::string text = echomap::fuzz::text_of({data, size});
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.starts_with('t')) {
      now_ms += 500.0;
    } else if (line.starts_with('x')) {
      close_client(handler, client_of(line.substr(1)));
    } else if (!line.empty()) {
      take_command(handler, client_of(line), line.substr(1));
    }
  }
  return 0;
}

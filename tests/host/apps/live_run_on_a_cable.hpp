// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/apps/live_run.hpp"
#include "host/session/pipeline_setup.hpp"
#include "tests/host/apps/live_page_visit.hpp"
#include "tests/host/session/session_on_a_cable.hpp"

namespace echomap::apps {

/// A run that explores.
inline LiveRunFacts exploring() {
  LiveRunFacts facts;
  facts.command = "explore";
  facts.out = "somewhere/first_map";
  return facts;
}

/// A run that follows a robot by a filter.
inline LiveRunFacts localizing() {
  LiveRunFacts facts;
  facts.command = "localize";
  return facts;
}

/// A run of a simulated robot.
inline LiveRunFacts simulated() {
  LiveRunFacts facts;
  facts.command = "demo";
  facts.is_simulated = true;
  return facts;
}

/// A fake robot on a cable that is shown at a page.
class LiveRunOnACable : public session::SessionOnACable {
 protected:
  LiveRunOnACable() {
    robot.begin_maps(session::kNoSlam);
    cable.robot.on_command = [this](std::string_view name) { commands.emplace_back(name); };
  }
  ~LiveRunOnACable() override { cable.robot.on_command = nullptr; }

  /// Serves the page, without what that prints.
  LiveRun& serve(const LiveRunFacts& facts = exploring()) {
    testing::internal::CaptureStderr();
    live.reset();
    live = std::make_unique<LiveRun>(page_at_any_port(), robot, facts);
    testing::internal::GetCapturedStderr();
    return *live;
  }
  void connect(std::unique_ptr<transport::LockstepChannel> lockstep = nullptr) {
    robot.open({new_connection(), std::move(lockstep)});
    robot.connect();
    commands.clear();
  }
  std::uint16_t port() const { return port_in(live->url()); }

  /// Lets the strategy drive for a minute of the robot and calls `act` after each step, with its
  /// number. Throws where it goes on for longer, as where nobody gives the robot back.
  exploration::MotionResult drive(const std::function<void(int step)>& act) {
    constexpr int kTooLong = 30'000;
    cable.robot.motion_ms = 60'000;
    int step = 0;
    const session::RobotContext::StepListener listener(robot, [&] {
      if (++step > kTooLong) {
        throw std::runtime_error("the drive does not end");
      }
      act(step);
    });
    return robot.execute(exploration::Drive{5.0});
  }
  live_page::HttpReply post(const std::string& command) const {
    return live_page::WebClient(port()).ask(live_page::post(port(), command));
  }
  /// The same, for what is not to be taken.
  void refuse(const std::string& text) const { EXPECT_EQ(post(text).status, 409) << text; }
  /// The same, for what is to be taken.
  void command(const std::string& text) const {
    const live_page::HttpReply reply = post(text);
    EXPECT_EQ(reply.status, 200) << text << ": " << reply.body;
  }

  std::vector<live_page::Message> messages(live_page::MessageKind kind) const {
    return of_kind(visited_history(port()), kind);
  }
  /// What a page is told that looks now.
  nlohmann::json state() const {
    live->look();
    const auto states = messages(live_page::MessageKind::kState);
    return states.empty() ? nlohmann::json() : json_in(states.back());
  }
  std::vector<std::string> events() const {
    std::vector<std::string> codes;
    for (const live_page::Message& event : messages(live_page::MessageKind::kEvent)) {
      codes.push_back(json_in(event).at("code"));
    }
    return codes;
  }

  session::RobotContext robot{profile, session::Seed(1)};
  std::unique_ptr<LiveRun> live;
  std::vector<std::string> commands;  ///< That the robot was told since it is connected.
};

/// A page by echomap.v1.
class PageClient {
 public:
  explicit PageClient(std::uint16_t port) : socket_(port, "echomap.v1") {
    number_ = nlohmann::json::parse(socket_.read_text()).at("client");
  }

  std::uint64_t number() const { return number_; }
  /// The server's answer to a command.
  nlohmann::json ask(const nlohmann::json& command) {
    socket_.send_text(command.dump());
    return nlohmann::json::parse(socket_.read_text());
  }
  /// Steers by what the page has just seen.
  nlohmann::json steer(double forward, double turn) {
    const auto clock = ask({{"do", "ping"}}).at("clock");
    return ask({{"do", "drive"}, {"forward", forward}, {"turn", turn}, {"seen", clock}});
  }
  void close() { socket_.close(); }

 private:
  live_page::WebSocketClient socket_;
  std::uint64_t number_ = 0;
};

}  // namespace echomap::apps

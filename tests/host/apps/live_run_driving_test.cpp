// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <unistd.h>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include "tests/host/apps/live_run_on_a_cable.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::apps {
namespace {

using exploration::MotionResult;
using session::OperatorMode;
using session::StandReason;
using testing::ElementsAre;
using testing::HasSubstr;

class LiveRunDriving : public LiveRunOnACable {
 protected:
  /// A motion that is ended at once ends by set-points of zero.
  std::optional<protocol::DriveSetpoint> first_that_moves() const {
    const auto& setpoints = cable.robot.setpoints;
    const auto first = std::find_if(setpoints.begin(), setpoints.end(), [](const auto& setpoint) {
      return setpoint.left_ticks_per_s != 0 || setpoint.right_ticks_per_s != 0;
    });
    return first == setpoints.end() ? std::nullopt : std::optional(*first);
  }
  bool stands() const { return robot.person()->mode() == OperatorMode::kStopped; }
};

TEST_F(LiveRunDriving, StopGoesOverTheWireAndTheRobotStandsUntilItMayExplore) {
  serve();
  connect();
  const MotionResult result = drive([&](int step) {
    if (step == 20) {
      command(R"({"do": "stop"})");
    } else if (step == 200) {
      EXPECT_THAT(commands, ElementsAre("MoveTicks", "Stop"));
      EXPECT_EQ(state().at("mode"), "stopped");
      EXPECT_EQ(state().at("stopped").at("code"), "stop");
      command(R"({"do": "explore"})");
    }
  });
  EXPECT_EQ(result, MotionResult::kTakenOver);
  EXPECT_THAT(commands, ElementsAre("MoveTicks", "Stop"));
  EXPECT_EQ(state().at("mode"), "explore");
  EXPECT_THAT(events(), testing::Contains("stop"));
}

TEST_F(LiveRunDriving, WhoDrivesTurnsTheWheelsUntilTheLockIsReleased) {
  serve();
  connect();
  PageClient page(port());
  page.ask({{"do", "name"}, {"name", "phone"}});
  int released = 0;
  const MotionResult result = drive([&](int step) {
    if (step >= 20 && !first_that_moves()) {
      EXPECT_EQ(page.steer(1.0, 0.0).at("ok"), true);
    } else if (first_that_moves() && released == 0) {
      const nlohmann::json told = state();
      EXPECT_EQ(told.at("mode"), "drive");
      EXPECT_EQ(told.at("driver"), (nlohmann::json{{"client", page.number()}, {"name", "phone"}}));
      EXPECT_EQ(told.at("why").at("code"), "operator");
      EXPECT_EQ(page.ask({{"do", "release"}}).at("ok"), true);
      released = step;
    } else if (released > 0 && step == released + 100) {
      EXPECT_TRUE(stands());
      EXPECT_TRUE(state().at("driver").is_null());
      command(R"({"do": "explore"})");
    }
  });
  EXPECT_EQ(result, MotionResult::kTakenOver);
  ASSERT_TRUE(first_that_moves());
  const protocol::DriveSetpoint first = *first_that_moves();
  EXPECT_GT(first.left_ticks_per_s, 0);
  EXPECT_EQ(first.left_ticks_per_s, first.right_ticks_per_s);
  EXPECT_EQ(commands.back(), "Stop") << "when it was released";
}

TEST_F(LiveRunDriving, TurnsCounterClockwiseByAPositiveTurn) {
  serve();
  connect();
  PageClient page(port());
  drive([&](int step) {
    if (step >= 20 && !first_that_moves()) {
      page.steer(0.0, 1.0);
    } else if (first_that_moves()) {
      page.ask({{"do", "explore"}});
    }
  });
  ASSERT_TRUE(first_that_moves());
  EXPECT_LT(first_that_moves()->left_ticks_per_s, 0);
  EXPECT_GT(first_that_moves()->right_ticks_per_s, 0);
}

TEST_F(LiveRunDriving, StopsWhereThePageThatDrivesIsClosed) {
  serve();
  connect();
  PageClient page(port());
  bool is_closed = false;
  drive([&](int step) {
    if (step >= 20 && !first_that_moves()) {
      page.steer(1.0, 0.0);
    } else if (first_that_moves() && !std::exchange(is_closed, true)) {
      page.close();
    } else if (is_closed && stands()) {
      EXPECT_THAT(robot.person()->reason(),
                  testing::AnyOf(StandReason::kDriverGone, StandReason::kDriverSilent));
      command(R"({"do": "explore"})");
    } else if (is_closed) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  EXPECT_EQ(commands.back(), "Stop");
  EXPECT_TRUE(state().at("stopped").is_null()) << "it explores again";
}

TEST_F(LiveRunDriving, TellsWhoSaysThatItWasMovedOrWhereItIs) {
  serve(localizing());
  connect();
  int moved = 0;
  geometry::Pose2 placed;
  live->show(
      nullptr,
      {.moved = [&] { ++moved; }, .placed = [&](const geometry::Pose2& pose) { placed = pose; }});
  drive([&](int step) {
    if (step == 10) {
      command(R"({"do": "moved"})");
      command(R"({"do": "pose", "x": 1, "y": 2, "heading": 0.5})");
    } else if (step == 20) {
      live->show_nothing();
      refuse(R"({"do": "moved"})");
      refuse(R"({"do": "pose", "x": 3, "y": 4, "heading": 0.5})");
    }
  });
  EXPECT_EQ(moved, 1) << "who was told first is gone";
  EXPECT_EQ(placed.x_m(), 1.0);
  EXPECT_EQ(placed.y_m(), 2.0);
  EXPECT_EQ(placed.heading_rad(), 0.5);
}

TEST_F(LiveRunDriving, TakesOfARealRobotNothingThatOnlyASimulatedOneCan) {
  serve();
  connect();
  for (const char* text : {R"({"do": "speed", "factor": 8})",
                           R"({"do": "carry-off"})",
                           R"({"do": "box", "x": 1, "y": 2})",
                           R"({"do": "cut-cable", "seconds": 4})",
                           R"({"do": "pose", "x": 1, "y": 2, "heading": 0})"}) {
    const live_page::HttpReply reply = post(text);
    EXPECT_EQ(reply.status, 409) << text;
    EXPECT_THAT(reply.body, HasSubstr("not-possible")) << text;
  }
}

/// The other end of a lockstep channel: what it is told.
class ToldDevice {
 public:
  ToldDevice() {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string path = folder_ / "lockstep";
    path.copy(static_cast<char*>(address.sun_path), sizeof address.sun_path - 1);
    ::bind(listening_, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    ::listen(listening_, 1);
    std::thread greeter([this] {
      connected_ = ::accept(listening_, nullptr, nullptr);
      constexpr std::string_view kHello =
          "{\"lockstep\":1,\"firmware\":\"echomap-uno 0.1.0\",\"emulator\":\"none\"}\n";
      EXPECT_EQ(::send(connected_, kHello.data(), kHello.size(), 0), ssize_t{kHello.size()});
    });
    channel = std::make_unique<transport::LockstepChannel>(path);
    greeter.join();
  }
  ~ToldDevice() {
    ::close(connected_);
    ::close(listening_);
  }
  ToldDevice(const ToldDevice&) = delete;
  ToldDevice& operator=(const ToldDevice&) = delete;

  /// All that has come so far.
  std::string told() const {
    std::array<char, 1024> bytes{};
    const ssize_t count = ::recv(connected_, bytes.data(), bytes.size(), MSG_DONTWAIT);
    return {bytes.data(), static_cast<std::size_t>(std::max(count, ssize_t{0}))};
  }

  std::unique_ptr<transport::LockstepChannel> channel;  ///< The host's end.

 private:
  const tests::ScratchFolder folder_;
  int listening_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  int connected_ = -1;
};

TEST_F(LiveRunDriving, DoesToASimulatedRobotWhatAPersonWants) {
  ToldDevice device;
  serve(simulated());
  connect(std::move(device.channel));
  drive([&](int step) {
    if (step == 10) {
      command(R"({"do": "carry-off"})");
      command(R"({"do": "box", "x": 1, "y": -0.5})");
      command(R"({"do": "cut-cable", "seconds": 1.5})");
      command(R"({"do": "speed", "factor": 16})");
      command(R"({"do": "stop"})");
    } else if (step == 20) {
      command(R"({"do": "explore"})");
    }
  });
  const std::string told = device.told();
  EXPECT_THAT(told, HasSubstr("carry-off 2000000\n"));
  EXPECT_THAT(told, HasSubstr("box 1000 -500 300\n"));
  EXPECT_THAT(told, HasSubstr("cut-cable 1500000\n"));
  EXPECT_EQ(robot.time_scale().factor(), 16.0);
  EXPECT_EQ(state().at("speed"), 16.0);
  EXPECT_THAT(events(), testing::IsSupersetOf({"carried-off", "box", "cable-cut"}));
}

}  // namespace
}  // namespace echomap::apps

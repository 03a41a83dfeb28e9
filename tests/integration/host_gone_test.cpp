// SPDX-License-Identifier: MIT
/// A host that is killed, one that freezes, and a cable that is cut, while the robot moves: each
/// board's wheels stop within the time to live and the braking, in the robot's time.
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/host/transport/pty_pair.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/every_seed.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::test {
namespace {

namespace fs = std::filesystem;

using tests::kMs;
/// Time to live, braking from the fastest speed, and a control period.
constexpr std::int64_t kLongestStopNs = (200 + 128 + 4) * kMs;
/// What the robot's receive credit of 128 bytes takes on the line, and a step of the world.
constexpr std::int64_t kLineNs = 12 * kMs;

struct Board {
  const char* name;
  const char* program;
};

/// A robot in a room and a host that explores it.
class HostGone : public ::testing::TestWithParam<Board> {
 protected:
  void SetUp() override {
    if (!fs::exists(std::string(ECHOMAP_BINARY_DIR "/bin/") + GetParam().program)) {
      GTEST_SKIP() << GetParam().program << " was not built on this machine";
    }
    if (std::string(GetParam().name) == "mega" && !tests::runs_every_seed()) {
      GTEST_SKIP() << "left to ./run test --full: the Uno runs the same firmware";
    }
  }

  std::string path(const std::string& name) const { return (scratch / name).string(); }

  Program start_robot(int seed, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{
        "--link=" + path("robot"), "--truth=" + path("truth"), "--seed=" + std::to_string(seed)};
    if (GetParam().program == std::string("echomap-simavr")) {
      arguments.push_back(std::string("--board=") + GetParam().name);
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
    return {GetParam().program, arguments, scratch / "robot.log"};
  }

  Program start_host(int seed, const std::string& port, const std::vector<std::string>& more) {
    // It drives more of its time than frontier, which looks longer.
    std::vector<std::string> arguments{"explore",
                                       "--strategy=nxt-farthest",
                                       "--port=" + port,
                                       "--out=" + path("run"),
                                       "--seed=" + std::to_string(seed)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return {"echomap", arguments, scratch / "host.log"};
  }

  /// Waits for the end of the first stop, after which the robot turns and drives.
  /// A slow emulator gets there later, so every further seed has 0.2 s more.
  void await_first_move(int seed) {
    EXPECT_TRUE(eventually([&] { return fs::exists(path("run/summary.json")); }))
        << files::read_text_file(scratch / "host.log");
    std::this_thread::sleep_for(std::chrono::milliseconds(200 * (seed - 1)));
  }

  nlohmann::json truth() const {
    return nlohmann::json::parse(files::read_text_file(scratch / "truth/truth.json"));
  }

  /// Lets a robot in real time go on without its host, then ends it; how long it drove after the
  /// last byte that it heard, negative where it stood by then. On a busy machine its time may go on
  /// for too short to tell: then 0, and every further seed has two seconds more.
  std::int64_t ns_driven_without_host(Program& robot, int seed) {
    std::this_thread::sleep_for(std::chrono::seconds(2 * seed));
    robot.send(SIGTERM);
    robot.wait();
    const nlohmann::json told = truth();
    const auto heard_ns = told.at("last_heard_ns").get<std::int64_t>();
    if (told.at("sim_seconds").get<double>() <= 1e-9 * double(heard_ns + 2 * kLongestStopNs)) {
      return 0;
    }
    return told.at("last_driven_ns").get<std::int64_t>() - heard_ns;
  }

  /// Runs `drive_on`, which answers for how long the robot drove on, with seeds until it did.
  template <class DriveOn>
  void expect_stop(std::int64_t bound_ns, DriveOn drive_on) {
    for (int seed = 1; seed <= 8; ++seed) {
      fs::remove_all(path("run"));
      fs::remove_all(path("truth"));
      const std::int64_t ns = drive_on(seed);
      std::printf(
          "%s, seed %d: wheels at zero after %.1f ms\n", GetParam().name, seed, 1e-6 * double(ns));
      ASSERT_LE(ns, bound_ns) << "seed " << seed;
      if (ns > 0) {
        return;
      }
    }
    FAIL() << "the robot never moved when its host went, or its time went on for too short to tell";
  }

  tests::ScratchFolder scratch;
};

TEST_P(HostGone, WheelsStopAfterTheHostIsKilled) {
  expect_stop(kLongestStopNs, [this](int seed) -> std::int64_t {
    fs::remove(path("lockstep"));
    const std::string lockstep = "--lockstep=" + path("lockstep");
    Program robot = start_robot(seed, {lockstep});
    EXPECT_TRUE(eventually([&] { return fs::exists(path("lockstep")); }));
    Program host = start_host(seed, path("robot"), {lockstep});
    await_first_move(seed);
    host.send(SIGKILL);
    host.wait();
    const Ended ended = robot.wait();
    EXPECT_EQ(ended.status, 0) << ended.said;
    return truth().at("stop").at("stopped_after_ns");
  });
}

TEST_P(HostGone, WheelsStopWhileTheHostIsFrozen) {
  expect_stop(kLongestStopNs + kLineNs, [this](int seed) {
    Program robot = start_robot(seed, {});
    EXPECT_TRUE(eventually([&] { return fs::exists(path("robot")); }));
    Program host = start_host(seed, path("robot"), {"--robot=uno_2wd"});
    await_first_move(seed);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    host.send(SIGSTOP);
    const std::int64_t driven_ns = ns_driven_without_host(robot, seed);
    host.send(SIGKILL);
    host.wait();
    return driven_ns;
  });
}

/// A cable between a robot's port and one for its host, until it is cut.
class Cable {
 public:
  explicit Cable(const std::string& robot)
      : robot_(::open(robot.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)),
        carrier_([this] { carry(); }) {}
  ~Cable() { cut(); }
  Cable(const Cable&) = delete;
  Cable& operator=(const Cable&) = delete;

  const std::string& host_port() const { return host_.name(); }
  /// The host's port goes away; the robot hears no more.
  void cut() {
    is_cut_ = true;
    if (carrier_.joinable()) {
      carrier_.join();
      host_.unplug();
    }
  }

 private:
  void carry() {
    while (!is_cut_) {
      pollfd ends[] = {{host_.fd(), POLLIN, 0}, {robot_.get(), POLLIN, 0}};
      ::poll(ends, 2, 10);
      for (const int from : {0, 1}) {
        std::uint8_t bytes[256];
        if ((ends[from].revents & POLLIN) != 0) {
          const ssize_t got = ::read(ends[from].fd, bytes, sizeof bytes);
          if (got <= 0) {
            return;
          }
          EXPECT_EQ(::write(ends[1 - from].fd, bytes, static_cast<std::size_t>(got)), got);
        }
      }
    }
  }

  transport::PtyPair host_;
  transport::FileDescriptor robot_;
  std::atomic<bool> is_cut_ = false;
  std::thread carrier_;
};

TEST_P(HostGone, WheelsStopAfterTheCableIsCut) {
  expect_stop(kLongestStopNs + kLineNs, [this](int seed) {
    Program robot = start_robot(seed, {});
    EXPECT_TRUE(eventually([&] { return fs::exists(path("robot")); }));
    Cable cable(path("robot"));
    Program host = start_host(seed, cable.host_port(), {"--robot=uno_2wd"});
    await_first_move(seed);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    cable.cut();
    const std::int64_t driven_ns = ns_driven_without_host(robot, seed);
    EXPECT_EQ(host.wait().status, 5) << "the host says that the link is lost";
    return driven_ns;
  });
}

INSTANTIATE_TEST_SUITE_P(Boards,
                         HostGone,
                         ::testing::Values(Board{"uno", "echomap-simavr"},
                                           Board{"mega", "echomap-simavr"},
                                           Board{"stm32f103", "echomap-unicorn"}),
                         [](const auto& board) { return std::string(board.param.name); });

}  // namespace
}  // namespace echomap::test

// SPDX-License-Identifier: MIT
#include <atomic>
#include <csignal>
#include <fcntl.h>
#include <string>
#include <thread>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/mount.h>

#include "host/files/atomic_file.hpp"
#include "tests/host/transport/pty_pair.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

using files::read_text_file;
using files::write_text_file;
using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

class BadInput : public ::testing::Test {
 protected:
  Ended echomap(std::vector<std::string> arguments) {
    return Program("echomap", std::move(arguments), scratch / "log").wait();
  }
  std::string out() const { return "--out=" + (scratch / "run").string(); }

  /// A simulated robot of its own, in lockstep or paced.
  std::unique_ptr<Program> start_mock(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"--link=" + (scratch / "robot").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    auto mock = std::make_unique<Program>("echomap-mock", arguments, scratch / "mock.log");
    EXPECT_TRUE(eventually([&] { return fs::exists(scratch / "robot"); }));
    return mock;
  }

  /// In the run directory's summary; 0 before there is one.
  int points_saved() const {
    const auto summary = scratch / "run/summary.json";
    return fs::exists(summary)
               ? nlohmann::json::parse(read_text_file(summary)).at("points").get<int>()
               : 0;
  }

  tests::ScratchFolder scratch;
};

/// A pty at whose other end some other program writes a line over and over, or nothing at all.
class OtherProgram {
 public:
  explicit OtherProgram(std::string line) {
    ::fcntl(pty_.fd(), F_SETFL, O_NONBLOCK);
    writer_ = std::thread([this, line = std::move(line)] {
      while (!stopped_) {
        if (!line.empty()) {
          EXPECT_GT(::write(pty_.fd(), line.data(), line.size()), 0);
        }
        hear();
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
      }
    });
  }
  ~OtherProgram() {
    stopped_ = true;
    writer_.join();
  }
  const std::string& port() const { return pty_.name(); }
  /// Frames that came, which end with a zero.
  int hellos() const { return hellos_; }

 private:
  void hear() {
    char byte = 0;
    char last = 0;
    while (::read(pty_.fd(), &byte, 1) == 1) {
      hellos_ += byte == 0 && last != 0 ? 1 : 0;
      last = byte;
    }
  }

  transport::PtyPair pty_;
  std::atomic<bool> stopped_ = false;
  std::atomic<int> hellos_ = 0;
  std::thread writer_;
};

TEST_F(BadInput, AMissingPortIsNamedWithTheNextCommand) {
  const Ended ended = echomap({"explore", "--port=/dev/ttyNONE", out()});
  EXPECT_EQ(ended.status, 3);
  EXPECT_THAT(ended.said, AllOf(HasSubstr("/dev/ttyNONE"), HasSubstr("next: ")));
}

TEST_F(BadInput, AnotherProgramOnThePortIsShown) {
  const OtherProgram other("temperature 21.5\r\n");
  const Ended ended = echomap({"explore", "--port=" + other.port(), out()});
  EXPECT_EQ(ended.status, 3);
  EXPECT_THAT(ended.said, AllOf(HasSubstr("no echomap frame"), HasSubstr("temperature 21")));
}

TEST_F(BadInput, ASilentPortIsCalledSilent) {
  const OtherProgram silent("");
  const Ended ended = echomap({"explore", "--port=" + silent.port(), out()});
  EXPECT_EQ(ended.status, 3);
  EXPECT_THAT(ended.said, HasSubstr("nothing answers"));
}

TEST_F(BadInput, OfManyPortsTheOneRobotIsChosen) {
  const OtherProgram modem("ERROR\r\n");
  const OtherProgram printer(std::string(1, '\x12'));
  const OtherProgram garbage("\xf0\x0f\x01\x80\xff");
  const OtherProgram silent("");
  const auto mock = start_mock({"--speed=5"});
  std::vector<std::string> arguments{"explore", "--stops=1", out()};
  for (const OtherProgram* other : {&modem, &printer, &garbage, &silent}) {
    arguments.push_back("--port=" + other->port());
  }
  arguments.push_back("--port=" + (scratch / "robot").string());
  const Ended ended = echomap(arguments);
  EXPECT_EQ(ended.status, kUnfinished) << ended.said;
  for (const OtherProgram* other : {&modem, &printer, &garbage, &silent}) {
    EXPECT_EQ(other->hellos(), 1) << other->port();
  }
  mock->send(SIGTERM);
}

TEST_F(BadInput, SeveralPortsWithoutARobotAreListed) {
  const OtherProgram modem("ERROR\r\n");
  const OtherProgram silent("");
  const Ended ended =
      echomap({"explore", "--port=" + modem.port(), "--port=" + silent.port(), out()});
  EXPECT_EQ(ended.status, 3);
  EXPECT_THAT(ended.said,
              AllOf(HasSubstr("no robot answers"),
                    HasSubstr("ERROR"),
                    HasSubstr(silent.port() + ": silent")));
}

TEST_F(BadInput, AReportThatCannotBeWrittenIsSaidBeforeTheRobotIsAsked) {
  const OtherProgram silent("");
  const auto report = (scratch / "no_folder/report.json").string();
  const Ended ended = echomap({"explore", "--port=" + silent.port(), "--json=" + report, out()});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.said, HasSubstr(report));
}

TEST_F(BadInput, ABrokenWorldIsPlaced) {
  const std::string path = (scratch / "room.toml").string();
  write_text_file(path, "name = 'room'\n[room]\ncorners_m = [[0, 0], [1, 0], [1, 1]\n");
  const Ended syntax = echomap({"demo", "--emulator=mock", "--world=" + path, out()});
  EXPECT_EQ(syntax.status, 6);
  EXPECT_THAT(syntax.said, HasSubstr(path + ":"));

  write_text_file(path, "name = 'room'\n[room]\ncorner_m = [[0, 0], [1, 0], [1, 1]]\n");
  const Ended key = echomap({"demo", "--emulator=mock", "--world=" + path, out()});
  EXPECT_EQ(key.status, 6);
  EXPECT_THAT(key.said, HasSubstr(path + ":2:1: 'corners_m' is missing"));
}

TEST_F(BadInput, ABrokenProfileIsPlaced) {
  const std::string path = (scratch / "robot.toml").string();
  std::string profile = read_text_file(ECHOMAP_SOURCE_DIR "/host/profiles/uno_2wd.toml");
  profile.insert(profile.find("settle_ms"), "speeed_deg_per_s = 4\n");
  write_text_file(path, profile);
  const Ended ended = echomap({"explore", "--port=/dev/null", "--robot=" + path, out()});
  EXPECT_EQ(ended.status, 6);
  EXPECT_THAT(ended.said, HasSubstr("did you mean 'speed_deg_per_s'?"));
}

/// A disk of 64 KiB at `folder`, gone with this.
class SmallDisk {
 public:
  explicit SmallDisk(const fs::path& folder) : folder_(folder) {
    fs::create_directories(folder_);
    mounted_ = ::mount("echomap-test", folder_.c_str(), "tmpfs", 0, "size=64k") == 0;
  }
  ~SmallDisk() {
    if (mounted_) {
      ::umount(folder_.c_str());
    }
  }
  bool mounted() const { return mounted_; }

 private:
  fs::path folder_;
  bool mounted_ = false;
};

TEST_F(BadInput, AFullDiskIsSaidAndKeepsWhatWasThere) {
  const SmallDisk disk(scratch / "run");
  if (!disk.mounted()) {
    GTEST_SKIP() << "only root can mount a small disk";
  }
  write_text_file(scratch / "run/map.pgm", "older map");
  write_text_file(scratch / "run/ballast", std::string(56U << 10U, 'x'));
  const Ended ended = echomap({"demo", "--emulator=mock", "--stops=2", out()});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.said, HasSubstr("No space left on device"));
  EXPECT_EQ(read_text_file(scratch / "run/map.pgm"), "older map");
  for (const auto& file : fs::directory_iterator(scratch / "run")) {
    EXPECT_NE(file.path().extension(), ".part") << file.path();
  }
}

TEST_F(BadInput, APortThatGoesInMidRunKeepsTheMap) {
  const auto lockstep = (scratch / "lockstep").string();
  const auto mock = start_mock({"--lockstep=" + lockstep});
  Program explore(
      "echomap",
      {"explore", "--port=" + (scratch / "robot").string(), "--lockstep=" + lockstep, out()},
      scratch / "log");
  ASSERT_TRUE(eventually([&] { return fs::exists(scratch / "run/summary.json"); }));
  mock->send(SIGKILL);
  const Ended ended = explore.wait();
  EXPECT_EQ(ended.status, 5) << ended.said;
  EXPECT_THAT(ended.said, HasSubstr("map so far is saved"));
  const auto summary = nlohmann::json::parse(read_text_file(scratch / "run/summary.json"));
  EXPECT_EQ(summary.at("outcome"), "link-lost");
  EXPECT_GT(summary.at("points"), 20);
}

TEST_F(BadInput, APacedRobotThatGoesKeepsTheMap) {
  const auto mock = start_mock({});
  Program explore("echomap",
                  {"explore", "--port=" + (scratch / "robot").string(), "--robot=uno_2wd", out()},
                  scratch / "log");
  ASSERT_TRUE(eventually([&] { return points_saved() > 5; }));
  mock->send(SIGKILL);
  const Ended ended = explore.wait();
  EXPECT_EQ(ended.status, 5) << ended.said;
  EXPECT_GT(points_saved(), 5);
}

}  // namespace
}  // namespace echomap::test

// SPDX-License-Identifier: MIT
#include "host/transport/lockstep_channel.hpp"

#include <functional>
#include <istream>
#include <thread>

#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/streambuf.hpp>
#include <boost/asio/write.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/transport/transport_error.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::transport {
namespace {

using boost::asio::local::stream_protocol;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kHello =
    "{\"lockstep\":1,\"firmware\":\"echomap-uno 0.1.0\",\"emulator\":\"simavr 1.6\"}\n";

constexpr const char* kNoAnswer = "no answer";

/// A device that says hello and answers each line as its script says; an empty answer hangs up.
class ScriptedDevice {
 public:
  using Script = std::function<std::string(const std::string& line)>;

  ScriptedDevice(std::string hello, Script script)
      : thread_([this, hello = std::move(hello), script = std::move(script)] {
          serve(hello, script);
        }) {}
  ~ScriptedDevice() { join(); }

  std::string path() const { return (folder_ / "lockstep").string(); }
  /// The lines that the host sent; call it when the host is gone.
  const std::vector<std::string>& lines() {
    join();
    return lines_;
  }

 private:
  void join() {
    if (thread_.joinable()) {
      thread_.join();
    }
  }

  void serve(const std::string& hello, const Script& script) {
    stream_protocol::socket host = acceptor_.accept();
    boost::asio::write(host, boost::asio::buffer(hello));
    boost::asio::streambuf buffer;
    boost::system::error_code error;
    while (boost::asio::read_until(host, buffer, '\n', error) > 0 && !error) {
      std::string line;
      std::istream input(&buffer);
      std::getline(input, line);
      lines_.push_back(line);
      const std::string answer = script(line);
      if (answer.empty()) {
        break;
      }
      if (answer == kNoAnswer) {
        continue;
      }
      boost::asio::write(host, boost::asio::buffer(answer), error);
    }
  }

  tests::ScratchFolder folder_;
  boost::asio::io_context io_;
  stream_protocol::acceptor acceptor_{io_, stream_protocol::endpoint(path())};
  std::vector<std::string> lines_;
  std::thread thread_;
};

std::string obedient(const std::string& line) {
  if (line == "quit") {
    return "bye\n";
  }
  if (!line.starts_with("grant")) {
    return kNoAnswer;
  }
  return "reached " + line.substr(6, line.rfind(' ') - 6) + " 4711\n";
}

TEST(LockstepChannel, LearnsWhatRunsAtTheOtherEnd) {
  ScriptedDevice device(kHello, obedient);
  const LockstepChannel channel(device.path());
  EXPECT_EQ(channel.device().firmware, "echomap-uno 0.1.0");
  EXPECT_EQ(channel.device().emulator, "simavr 1.6");
}

TEST(LockstepChannel, GrantsTimeAndEndsTheDevice) {
  ScriptedDevice device(kHello, obedient);
  {
    LockstepChannel channel(device.path());
    const auto reached = channel.grant(5'000, 17);
    ASSERT_TRUE(reached);
    EXPECT_EQ(reached->until_us, 5'000);
    EXPECT_EQ(reached->device_bytes, 4711U);
    channel.carry_off(std::chrono::seconds(2));
    EXPECT_TRUE(channel.grant(7'000'000'000'000, 18));
    EXPECT_TRUE(channel.quit());
    EXPECT_EQ(channel.close_reason(), "");
  }
  EXPECT_THAT(device.lines(),
              ElementsAre("grant 5000 17", "carry-off 2000000", "grant 7000000000000 18", "quit"));
}

TEST(LockstepChannel, KnowsTheTruthOnlyWhereItAsks) {
  bool tells = false;
  ScriptedDevice device(kHello, [&tells](const std::string& line) {
    tells = tells || line == "tell-truth";
    return tells && line.starts_with("grant") ? "reached 2000 0 1000000 0 0\n" : obedient(line);
  });
  LockstepChannel channel(device.path());
  EXPECT_TRUE(channel.grant(1'000, 0));
  EXPECT_FALSE(channel.true_pose());
  channel.tell_truth();
  EXPECT_FALSE(channel.true_pose()) << "it comes with the next grant";
  ASSERT_TRUE(channel.grant(2'000, 0));
  ASSERT_TRUE(channel.true_pose());
  EXPECT_EQ(channel.true_pose()->x_m, 1.0);
}

TEST(LockstepChannel, CutsTheCable) {
  ScriptedDevice device(kHello, obedient);
  {
    LockstepChannel channel(device.path());
    channel.cut_cable(std::chrono::seconds(3));
    EXPECT_TRUE(channel.quit());
  }
  EXPECT_THAT(device.lines(), ElementsAre("cut-cable 3000000", "quit"));
}

TEST(LockstepChannel, PutsABoxDownInWholeMillimetres) {
  ScriptedDevice device(kHello, obedient);
  {
    LockstepChannel channel(device.path());
    channel.put_box(1.5004, -0.25, 0.3);
    EXPECT_TRUE(channel.quit());
  }
  EXPECT_THAT(device.lines(), ElementsAre("box 1500 -250 300", "quit"));
}

TEST(LockstepChannel, KnowsADeviceThatDiesInAGrant) {
  ScriptedDevice device(kHello, [](const std::string&) { return ""; });
  LockstepChannel channel(device.path());
  EXPECT_FALSE(channel.grant(5'000, 0));
  EXPECT_EQ(channel.close_reason(), "the other end closed it");
  EXPECT_FALSE(channel.grant(6'000, 0));
  EXPECT_FALSE(channel.quit());
}

TEST(LockstepChannel, KnowsADeviceThatHangs) {
  ScriptedDevice device(kHello, [](const std::string&) { return "reached 5000"; });
  LockstepChannel channel(device.path(), std::chrono::milliseconds(50));
  EXPECT_FALSE(channel.grant(5'000, 0));
  EXPECT_EQ(channel.close_reason(), "the device does not answer");
}

TEST(LockstepChannel, RefusesAnswersThatAreNotTheGrants) {
  for (const char* wrong : {"reached 4999 0\n",
                            "reached 5000\n",
                            "reached 5000 0 0\n",
                            "reached five 0\n",
                            "bye\n",
                            "\n"}) {
    ScriptedDevice device(kHello, [wrong](const std::string&) { return wrong; });
    LockstepChannel channel(device.path());
    EXPECT_FALSE(channel.grant(5'000, 0)) << wrong;
    EXPECT_THAT(channel.close_reason(), HasSubstr("answered a grant with")) << wrong;
  }
}

TEST(LockstepChannel, RefusesAHelloThatIsNone) {
  for (const char* wrong : {"hello\n",
                            "{\"lockstep\":2,\"firmware\":\"f\",\"emulator\":\"e\"}\n",
                            "{\"lockstep\":1,\"firmware\":7,\"emulator\":\"e\"}\n",
                            "{\"lockstep\":1}\n",
                            "[1]\n",
                            "{\n"}) {
    ScriptedDevice device(wrong, obedient);
    EXPECT_THROW(LockstepChannel(device.path()), TransportError) << wrong;
  }
}

}  // namespace
}  // namespace echomap::transport

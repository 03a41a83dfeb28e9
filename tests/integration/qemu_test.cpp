// SPDX-License-Identifier: MIT
/// The STM32F103's image in an emulator that other people wrote: QEMU's stm32vldiscovery has the
/// same core, SysTick and USART, and reads 0 from every other register.
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/apps/child_process.hpp"
#include "host/robot_link/robot_link.hpp"
#include "host/time/host_time.hpp"
#include "host/transport/local_stream.hpp"
#include "protocol/version.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

namespace fs = std::filesystem;
using robot_link::CommandOutcome;

const fs::path qemu = ECHOMAP_QEMU_ARM;
const fs::path image = ECHOMAP_BINARY_DIR "/firmware/echomap-stm32f103.elf";

/// What the robot has said.
class Listener : public robot_link::RobotLinkListener {
 public:
  void on_odometry(const protocol::Odometry& message) override { odometry.push_back(message); }
  void on_command_done(const robot_link::CommandResult& result) override {
    outcome = result.outcome;
  }

  std::vector<protocol::Odometry> odometry;
  std::optional<CommandOutcome> outcome;
};

class Qemu : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(qemu) || !fs::exists(image)) {
      GTEST_SKIP() << "qemu-system-arm is not installed or the STM32F103's image was not built";
    }
    const fs::path socket = scratch / "serial";
    machine_.emplace(std::vector<std::string>{qemu.string(),
                                              "-machine",
                                              "stm32vldiscovery",
                                              "-kernel",
                                              image.string(),
                                              "-nographic",
                                              "-monitor",
                                              "none",
                                              "-serial",
                                              "unix:" + socket.string() + ",server=on,wait=off"},
                     scratch / "qemu.log");
    ASSERT_TRUE(eventually([&] { return fs::exists(socket); }));
    stream_ = transport::open_local_stream(socket.string());
  }

  /// Passes bytes both ways until `done`; false after a minute.
  template <class Done>
  bool serve_until(const Done& done) {
    return eventually([&] {
      std::vector<std::uint8_t> bytes(256);
      bytes.resize(stream_->read_some(bytes, std::chrono::milliseconds(5)));
      const time::HostTime now(std::chrono::duration_cast<time::HostClock::duration>(
          std::chrono::steady_clock::now() - start_));
      link.receive(bytes, now);
      link.poll(now);
      stream_->write(link.take_outgoing());
      return done();
    });
  }

  tests::ScratchFolder scratch;
  Listener listener;
  robot_link::RobotLink link{listener, 4711};

 private:
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::optional<apps::ChildProcess> machine_;
  std::unique_ptr<transport::ByteStream> stream_;
};

TEST_F(Qemu, ShakesHandsAnswersPingsAndReportsItsWheels) {
  ASSERT_TRUE(serve_until([&] { return link.state() == robot_link::LinkState::kReady; }));
  EXPECT_EQ(link.robot()->schema_digest, protocol::kSchemaDigest);
  EXPECT_EQ(link.robot()->firmware_version, protocol::kFirmwareVersion);

  link.submit(protocol::Arm{0, 1});
  ASSERT_TRUE(serve_until([&] { return listener.outcome.has_value(); }));
  EXPECT_EQ(*listener.outcome, CommandOutcome::kAccepted);

  listener.odometry.clear();
  ASSERT_TRUE(serve_until([&] { return listener.odometry.size() > 100; }));
  EXPECT_TRUE(link.clock().host_time(listener.odometry.back().stamp_us)) << "no Ping answered";
  EXPECT_EQ(link.statistics().frames_bad, 0U);
  EXPECT_EQ(link.statistics().resets_seen, 0U);
  const std::uint32_t lasted_us = listener.odometry[100].stamp_us - listener.odometry[0].stamp_us;
  EXPECT_NEAR(double(lasted_us), 100 * 20'000.0, 2'000.0) << "on the guest's own clock";
}

}  // namespace
}  // namespace echomap::test

// SPDX-License-Identifier: MIT
/// The STM32F103's image in an emulator that other people wrote: QEMU's stm32vldiscovery has the
/// same core, SysTick and USART, and reads 0 from every other register.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/robot_link/robot_link.hpp"
#include "host/session/child_process.hpp"
#include "host/time/host_time.hpp"
#include "host/transport/local_stream.hpp"
#include "host/transport/transport_error.hpp"
#include "protocol/version.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/median.hpp"
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
    ASSERT_TRUE(eventually([&] { return answers(socket); }));
  }

  /// Opens the machine's socket; it is there a moment before the machine listens to it.
  bool answers(const fs::path& socket) {
    try {
      stream_ = transport::open_local_stream(socket.string());
    } catch (const transport::TransportError&) {
      return false;
    }
    return true;
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
  std::optional<session::ChildProcess> machine_;
  std::unique_ptr<transport::ByteStream> stream_;
};

/// Whether the last hundred steps from report to report are as long as `step_us` says, most of
/// them: a machine that was kept waiting leaves reports out, and then catches up for a while.
bool comes_every(double step_us, const std::vector<protocol::Odometry>& odometry) {
  constexpr std::size_t kSteps = 100;
  std::vector<double> steps_us;
  for (std::size_t i = odometry.size(); i > 1 && steps_us.size() < kSteps; --i) {
    steps_us.push_back(odometry[i - 1].stamp_us - odometry[i - 2].stamp_us);
  }
  return steps_us.size() == kSteps && std::abs(tests::median(steps_us) - step_us) < 0.01 * step_us;
}

TEST_F(Qemu, ShakesHandsAnswersPingsAndReportsItsWheels) {
  ASSERT_TRUE(serve_until([&] { return link.state() == robot_link::LinkState::kReady; }));
  EXPECT_EQ(link.robot()->schema_digest, protocol::kSchemaDigest);
  EXPECT_EQ(link.robot()->firmware_version, protocol::kFirmwareVersion);

  link.submit(protocol::Arm{0, 1});
  ASSERT_TRUE(serve_until([&] { return listener.outcome.has_value(); }));
  EXPECT_EQ(*listener.outcome, CommandOutcome::kAccepted);

  listener.odometry.clear();
  ASSERT_TRUE(serve_until([&] { return comes_every(20'000.0, listener.odometry); }))
      << "on the guest's own clock";
  EXPECT_TRUE(link.clock().host_time(listener.odometry.back().stamp_us)) << "no Ping answered";
  EXPECT_EQ(link.statistics().frames_bad, 0U);
  EXPECT_EQ(link.statistics().resets_seen, 0U);
}

}  // namespace
}  // namespace echomap::test

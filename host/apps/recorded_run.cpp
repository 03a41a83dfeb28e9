// SPDX-License-Identifier: MIT
#include "host/apps/recorded_run.hpp"

#include <chrono>
#include <thread>

#include <spdlog/spdlog.h>

#include "host/console/exit_code.hpp"
#include "host/console/interrupt.hpp"
#include "host/files/atomic_file.hpp"
#include "host/mcap/mcap_reader.hpp"
#include "host/recording/session_file.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Lets real time pass until a recording that is played at that speed is so far.
class Pacer {
 public:
  Pacer(std::optional<double> speed, double begin_s) : speed_(speed), begin_s_(begin_s) {}

  void wait_for(double elapsed_s) const {
    if (speed_) {
      const std::chrono::duration<double> due((elapsed_s - begin_s_) / *speed_);
      std::this_thread::sleep_until(start_ + std::chrono::duration_cast<Clock::duration>(due));
    }
  }

 private:
  std::optional<double> speed_;
  double begin_s_;
  Clock::time_point start_ = Clock::now();
};

void throw_if_interrupted(const recording::SessionReader& recording) {
  if (console::interrupted()) {
    throw console::CommandError(
        console::ExitCode::kInterrupted,
        "interrupted in " + recording.path().string() + "; nothing was written");
  }
}

}  // namespace

std::optional<fs::path> recording_of(const fs::path& path) {
  const fs::path file = fs::is_directory(path) ? path / recording::kSessionFileName : path;
  const bool is_one = fs::is_regular_file(file) && recording::is_session_file(file);
  return is_one ? std::optional(file) : std::nullopt;
}

session::RobotProfile profile_of(const recording::SessionReader& recording) {
  const auto toml = recording.attachment("robot.toml");
  if (!toml) {
    throw files::FileError(recording.path().string() +
                           ": the robot's profile is missing at its beginning");
  }
  return session::parse_robot_profile(*toml, recording.path().string() + "/robot.toml");
}

Played play(recording::SessionReader& recording,
            const session::RobotProfile& profile,
            const session::PlayedInto& into,
            const PlayedPart& part,
            const std::function<void()>& on_stop) {
  session::SessionPlayer player(recording, profile, into);
  player.begin_at(part.from_s);
  const Pacer pacer(part.speed, part.from_s);
  Played played;
  try {
    while (recording.elapsed_s() <= part.until_s && player.play_next()) {
      throw_if_interrupted(recording);
      pacer.wait_for(recording.elapsed_s());
      if (player.has_ended_scan()) {
        on_stop();
      }
    }
    recording.read_ending();
  } catch (const mcap::CutOffFile& half) {
    spdlog::warn("the recording ends early, everything before was read: {}", half.what());
  } catch (const files::FileError& error) {
    played.damage = error.what();
  }
  played.observations = player.observations();
  played.duration_s = recording.elapsed_s();
  return played;
}

}  // namespace echomap::apps

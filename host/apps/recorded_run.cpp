// SPDX-License-Identifier: MIT
#include "host/apps/recorded_run.hpp"

#include <chrono>
#include <cmath>
#include <thread>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "host/console/exit_code.hpp"
#include "host/console/interrupt.hpp"
#include "host/exports/geojson.hpp"
#include "host/files/atomic_file.hpp"
#include "host/mcap/mcap_reader.hpp"
#include "host/recording/session_file.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

/// Lets real time pass until a recording that is played at that speed is so far, or the user has
/// had enough.
class Pacer {
 public:
  Pacer(std::optional<double> speed, double begin_s) : speed_(speed), begin_s_(begin_s) {}

  void wait_for(double elapsed_s) const {
    constexpr std::chrono::milliseconds kNap(50);
    const auto is_due = [&] {
      const std::chrono::duration<double> passed = Clock::now() - start_;
      return passed.count() * *speed_ >= elapsed_s - begin_s_;
    };
    while (speed_ && !is_due() && !console::interrupted()) {
      const std::chrono::duration<double> passed = Clock::now() - start_;
      const double left_s = (elapsed_s - begin_s_) / *speed_ - passed.count();
      std::this_thread::sleep_for(left_s < 0.05 ? std::chrono::duration<double>(left_s)
                                                : std::chrono::duration<double>(kNap));
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

/// Of a run that was killed before its first stop there is only what it had set out to do.
ordered_json report_of_begin(const recording::SessionReader& recording) {
  ordered_json json{{"outcome", "exploring"}, {"finished", false}, {"outline_by_strategy", false}};
  for (const char* key : {"strategy", "robot", "slam", "world", "firmware", "emulator"}) {
    json[key] = recording.fact("session", key);
  }
  return json;
}

/// A file of the run: the one in its directory or, where only the recording is there, the one
/// attached to it. Empty where there is neither.
std::optional<std::string> file_of_run(const fs::path& log,
                                       const char* name,
                                       const recording::SessionReader& recording) {
  const bool is_beside = fs::is_directory(log) && exists(log / name);
  return is_beside ? std::optional(files::read_text_file(log / name)) : recording.attachment(name);
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
                           ": the robot's profile is missing at its beginning" +
                           (recording.head_damage().empty() ? "" : ": ") + recording.head_damage());
  }
  return session::parse_robot_profile(*toml, recording.path().string() + "/robot.toml");
}

RunReport read_report(const fs::path& log, const recording::SessionReader& recording) {
  RunReport report;
  const auto text = file_of_run(log, "summary.json", recording);
  report.json = text ? ordered_json::parse(*text, nullptr, false) : report_of_begin(recording);
  try {
    report.json.at("slam").get_to(report.slam);
    report.json.at("outline_by_strategy").get_to(report.outline_by_strategy);
    report.world = report.json.value("world", "");
    report.robot = report.json.value("robot", "");
  } catch (const nlohmann::json::exception&) {
    throw files::FileError(
        log.string() +
        "/summary.json: not the summary of a run, slam or outline_by_strategy is "
        "missing");
  }
  return report;
}

geometry::Polygon outline_of(const fs::path& log,
                             const RunReport& report,
                             const recording::SessionReader& recording) {
  const auto text =
      report.outline_by_strategy ? file_of_run(log, "outline.geojson", recording) : std::nullopt;
  const auto outline =
      text ? exports::parse_outline_geojson(*text, log.string() + "/outline.geojson")
           : std::nullopt;
  return outline ? outline->outline_m() : geometry::Polygon{};
}

void validate(const PlayedPart& part) {
  constexpr double kMinSpeed = 1e-3;
  constexpr double kMaxSpeed = 1e6;
  if (!(part.from_s < part.until_s)) {
    throw console::CommandError(
        console::ExitCode::kUsage,
        fmt::format("--from {} is not before --until {}", part.from_s, part.until_s));
  }
  const double speed = part.speed.value_or(1.0);
  if (std::isnan(speed) || speed < kMinSpeed || speed > kMaxSpeed) {
    throw console::CommandError(
        console::ExitCode::kUsage,
        fmt::format("--speed {} is outside {} .. {}", speed, kMinSpeed, kMaxSpeed));
  }
}

void throw_if_empty(const pipeline::ObservationLog& played,
                    const PlayedPart& part,
                    const recording::SessionReader& recording) {
  if (played.observations() > 0) {
    return;
  }
  const bool is_whole = part == PlayedPart{.speed = part.speed};
  throw console::CommandError(
      console::ExitCode::kRuntimeError,
      is_whole
          ? recording.path().string() +
                " is empty: the run has recorded nothing\n  next: name another run"
          : fmt::format("nothing was recorded from {} s to {} s; the recording is read to {:.1f} s"
                        "\n  next: choose another --from and --until",
                        part.from_s,
                        part.until_s,
                        recording.elapsed_s()));
}

void throw_if_without_map(const recording::SessionReader& recording) {
  if (recording.fact("session", "command") == kLocalizeCommand) {
    throw console::CommandError(
        console::ExitCode::kRuntimeError,
        recording.path().string() +
            " is of a run that localized, and has no map\n  next: echomap localize " +
            recording.path().string() + " --map RUN");
  }
}

Played play(recording::SessionReader& recording,
            const session::RobotProfile& profile,
            const session::PlayedInto& into,
            const PlayedPart& part,
            const std::function<void()>& on_stop) {
  validate(part);
  session::SessionPlayer player(recording, profile, into);
  player.play_between(part.from_s, part.until_s);
  const Pacer pacer(part.speed, part.from_s);
  Played played;
  try {
    while (player.play_next()) {
      pacer.wait_for(recording.elapsed_s());
      throw_if_interrupted(recording);
      if (player.has_ended_scan()) {
        on_stop();
      }
    }
    played.duration_s = recording.elapsed_s();
    recording.read_ending();
    played.is_whole = !recording.fact("ending", "outcome").empty();
    if (!played.is_whole) {
      spdlog::warn(
          "{} has no ending: its program was killed, or a later file of it is missing; everything "
          "that is there was read",
          recording.path().string());
    }
  } catch (const mcap::CutOffFile& half) {
    played.is_whole = false;
    played.duration_s = recording.elapsed_s();
    spdlog::warn("the recording ends early; everything before was read: {}", half.what());
  } catch (const files::FileError& error) {
    played.duration_s = recording.elapsed_s();
    played.damage = error.what();
    played.is_whole = false;
  }
  played.observations = player.observations();
  return played;
}

}  // namespace echomap::apps

// SPDX-License-Identifier: MIT
#include "host/apps/played_history.hpp"

#include <optional>
#include <utility>

#include <spdlog/spdlog.h>

#include "host/apps/recorded_run.hpp"
#include "host/apps/run_ending.hpp"
#include "host/exports/run_directory.hpp"
#include "host/files/atomic_file.hpp"
#include "host/pipeline/joined_sessions.hpp"
#include "host/pipeline/observation_fork.hpp"
#include "host/session/pipeline_setup.hpp"
#include "host/session/session_player.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;

/// Of the robot's time.
constexpr double kMotionPeriodS = 0.1;

live_page::RunFacts facts_of(const recording::SessionReader& recording,
                             const std::string& id,
                             const std::string& name) {
  live_page::RunFacts facts;
  facts.id = id;
  facts.name = name;
  facts.version = recording.fact("session", "version");
  facts.command = recording.fact("session", "command");
  return facts;
}

live_page::RunResult result_of(const recording::SessionReader& recording, const Played& played) {
  if (!played.is_whole) {
    return {false,
            "cut-off",
            played.damage.empty() ? "the recording has no ending" : played.damage,
            ""};
  }
  return {recording.fact("ending", "finished") == "true",
          recording.fact("ending", "outcome"),
          recording.fact("ending", "why"),
          recording.fact("ending", "next")};
}

std::string name_of(const fs::path& run) {
  const fs::path whole = fs::weakly_canonical(run);
  return is_directory(whole) ? whole.filename().string() : whole.parent_path().filename().string();
}

}  // namespace

PlayedPublisher::PlayedPublisher(const recording::SessionReader& recording,
                                 const session::RobotProfile& profile,
                                 const pipeline::RobotAtlas& atlas,
                                 std::shared_ptr<live_page::RunPublisher> publisher)
    : recording_(recording),
      profile_(profile),
      atlas_(atlas),
      publisher_(std::move(publisher)),
      source_(atlas, nullptr, [this] { return progress(); }) {}

void PlayedPublisher::on(const sensors::Observation& observation) {
  publisher_->on(observation);
  const double time_s = recording_.elapsed_s();
  if (time_s >= next_motion_s_) {
    next_motion_s_ = time_s + kMotionPeriodS;
    publisher_->add_motion(time_s, atlas_.pipeline().pose_estimate());
  }
}

void PlayedPublisher::add_stop() {
  coverage_ = coverage_of(atlas_.pipeline().snapshot(), profile_);
  source_.publish(recording_.elapsed_s(), *publisher_);
  add_state();
}

void PlayedPublisher::end(const live_page::RunResult& result) {
  result_ = result;
  add_state();
}

LiveProgress PlayedPublisher::progress() const {
  exports::RunSummary summary;
  exports::describe_snapshot(atlas_.pipeline().snapshot(), summary);
  return {summary.stops,
          summary.free_area_m2,
          summary.travelled_m,
          recording_.elapsed_s(),
          std::nullopt,
          coverage_};
}

void PlayedPublisher::add_state() {
  live_page::RunState state;
  state.phase = live_page::RunState::Phase::kRecording;
  source_.describe(state);
  state.left_s = std::nullopt;
  state.result = result_;
  publisher_->add_state(recording_.elapsed_s(), state);
}

live_page::ServedRun played_run(const fs::path& run, const std::string& id) {
  const auto file = recording_of(run);
  if (!file) {
    throw files::FileError(run.string() +
                           ": neither a run directory with a recording nor a session.mcap\n"
                           "  next: name a run of echomap explore or demo");
  }
  recording::SessionReader recording(*file);
  throw_if_without_map(recording);
  const session::RobotProfile profile = profile_of(recording);
  pipeline::RobotAtlas atlas = session::atlas_for(profile, recording.fact("session", "slam"));
  const auto history = std::make_shared<live_page::History>();
  const std::string name = name_of(run);
  PlayedPublisher publisher(
      recording,
      profile,
      atlas,
      std::make_shared<live_page::RunPublisher>(history, facts_of(recording, id, name), profile));
  pipeline::ObservationFork fork;
  fork.add(atlas);
  fork.add(publisher);
  pipeline::JoinedSessions sessions(fork);
  const Played played =
      play(recording, profile, {sessions, atlas, &atlas}, {}, [&] { publisher.add_stop(); });
  if (!played.damage.empty()) {
    spdlog::warn("{}", played.damage);
  }
  publisher.end(result_of(recording, played));
  return {name, is_directory(run) ? run : fs::path(), history, false};
}

}  // namespace echomap::apps

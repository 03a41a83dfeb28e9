// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/live_score.hpp"
#include "host/apps/live_source.hpp"
#include "host/apps/run_ending.hpp"
#include "host/live_page/foxglove_topics.hpp"
#include "host/live_page/page_server.hpp"
#include "host/session/operator_queue.hpp"
#include "host/session/robot_context.hpp"

namespace echomap::apps {

/// What the page says of a run before it is connected.
struct LiveRunFacts {
  std::string command;
  std::filesystem::path out;  ///< The run directory.
  bool is_simulated = false;
};

/// What a person may tell of where the robot is, while it is shown; null where it cannot be told.
struct PersonsWord {
  std::function<void()> moved = nullptr;                                     ///< Anywhere else.
  std::function<void(const geometry::Pose2& T_map_robot)> placed = nullptr;  ///< About there.
};

/// The live page of a robot that is driven: serves it, shows what the session makes of the robot
/// and hands a person's commands to it. Without `LiveOptions::serves` it does nothing.
class LiveRun {
 public:
  /// `robot`, which is not open yet, outlives this. Says where the page is and opens it. Throws
  /// CommandError where it cannot listen.
  LiveRun(const LiveOptions& options, session::RobotContext& robot, const LiveRunFacts& facts);
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  bool serves() const { return server_ != nullptr; }
  /// Whether somebody may watch: there is a desktop, or a terminal that the URL is printed on.
  bool may_be_watched() const;
  /// Shows that from now on. A person may send the robot where it `can_go` by the map that it
  /// makes.
  void show(std::unique_ptr<LiveSource> source, const PersonsWord& word, bool can_go = false);
  /// What `show` was given is gone.
  void show_nothing() { show(nullptr, {}); }
  /// Publishes what has changed, at once: after a stop, while the robot stands.
  void look();
  /// Empty where nothing is served.
  std::string url() const { return server_ ? server_->url() : ""; }
  /// Something that only the command knows.
  void tell(const live_page::RunEvent& event);
  /// Scores the first map as it grows, against the truth directory of a simulated robot; where that
  /// cannot be read, it says so and does not score.
  void score_against(const std::filesystem::path& truth);
  /// Says how the run has ended, and serves on as long as somebody watches, until Ctrl-C.
  void end(const RunEnding& ending);

 private:
  void step();

  using WallTime = std::chrono::steady_clock::time_point;

  void serve(const LiveOptions& options, const LiveRunFacts& facts);
  void obey(const LiveRunFacts& facts);
  void look_around(WallTime now);
  void tell_events();
  live_page::RunState state() const;
  live_page::LinkHealth link_health() const;
  void score_map();
  nlohmann::ordered_json score() const;
  double time_s() const;
  std::optional<geometry::Pose2> true_pose() const;

  session::RobotContext& robot_;
  session::OperatorQueue queue_;
  std::shared_ptr<live_page::RunPublisher> publisher_;
  std::optional<live_page::FoxgloveTopics> topics_;
  std::optional<session::RobotContext::StepListener> listener_;
  std::unique_ptr<live_page::PageServer> server_;
  std::unique_ptr<LiveSource> source_;
  PersonsWord word_;
  bool is_simulated_;
  live_page::EventWatch events_;
  std::optional<LiveScore> score_;
  std::size_t scored_stops_ = 0;
  live_page::RunState progress_;  ///< As the source that is or was shown last has it.
  std::optional<live_page::RunResult> result_;
  WallTime next_motion_;
  double next_motion_s_ = 0.0;  ///< Of the run.
  WallTime next_look_;
  std::uint64_t frames_ = 0;  ///< When they were last counted.
  std::optional<double> frames_per_s_;
  WallTime counted_at_;
  bool has_other_map_ = false;  ///< Than the one that began where the robot started.
};

}  // namespace echomap::apps

// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/live_page/history.hpp"
#include "host/live_page/map_publisher.hpp"
#include "host/live_page/message_encoding.hpp"
#include "host/live_page/run_state.hpp"
#include "host/live_page/team_state.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::live_page {

/// What a run is, for its first message.
struct RunFacts {
  std::string id = "0";  ///< Among the runs that are served.
  std::string name;      ///< For people.
  std::string version;
  std::string command;
  bool live = false;
  bool has_truth = false;
  std::vector<std::string> can;  ///< Commands that it takes.
};

/// Something that happened, for people.
struct RunEvent {
  enum class Level : std::uint8_t { kInfo, kWarning, kError };
  std::string code;
  Level level = Level::kInfo;
  std::string text;
  std::string cause{};
  std::string remedy{};
};

/// Makes the messages of a run for a history: live, or as its recording is played.
class RunPublisher final : public pipeline::AnyObservationSink {
 public:
  RunPublisher(std::shared_ptr<History> history,
               const RunFacts& facts,
               const session::RobotProfile& profile);

  /// From now on the run takes these commands.
  void set_can(double time_s, std::vector<std::string> can);
  /// Remembers the last ping, battery and hazards.
  void on(const sensors::Observation& observation) override;

  void add_motion(double time_s,
                  const pipeline::PoseEstimate& pose,
                  const std::optional<geometry::Pose2>& T_map_true_robot = std::nullopt);
  void add_particles(double time_s, const std::vector<WeightedPose>& particles);
  /// Where it is another one than before; link, score and time left are told once a second.
  void add_state(double time_s, const RunState& state);
  void add_event(double time_s, const RunEvent& event);
  /// Where it is another one than before.
  void add_team(double time_s, const TeamState& team);

  MapPublisher& map() { return map_; }
  const std::shared_ptr<History>& history() const { return history_; }
  std::optional<double> battery_v() const { return battery_v_; }
  const sensors::HazardObservation& hazards() const { return hazards_; }

 private:
  std::shared_ptr<History> history_;
  MapPublisher map_;
  nlohmann::ordered_json hello_;
  LastPing ping_;
  std::optional<double> battery_v_;
  sensors::HazardObservation hazards_;
  nlohmann::ordered_json state_;
  nlohmann::ordered_json lasting_state_;  ///< Without what changes all the time.
  double state_s_ = 0.0;
  nlohmann::ordered_json team_;
};

}  // namespace echomap::live_page

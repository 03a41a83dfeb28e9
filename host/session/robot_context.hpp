// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "host/diagnosis/encoder_check.hpp"
#include "host/diagnosis/self_check.hpp"
#include "host/diagnosis/sonar_check.hpp"
#include "host/pipeline/joined_sessions.hpp"
#include "host/pipeline/observation_fork.hpp"
#include "host/pipeline/robot_atlas.hpp"
#include "host/session/follower.hpp"
#include "host/session/open_robot.hpp"
#include "host/session/operator_control.hpp"
#include "host/session/recording_log.hpp"
#include "host/session/robot_profile.hpp"
#include "host/session/robot_session.hpp"
#include "host/session/seed.hpp"
#include "host/session/time_scale.hpp"

namespace echomap::session {

/// What a command that drives a robot is assembled from, in this order: its profile and the seed,
/// the maps or the follower (or both) that its observations go to, its open port.
class RobotContext {
 public:
  RobotContext(RobotProfile profile, const Seed& seed);
  RobotContext(const RobotContext&) = delete;
  RobotContext& operator=(const RobotContext&) = delete;

  /// Maps what the robot senses. The SLAM method of that name places it (`pipeline_for`).
  void begin_maps(const std::string& slam);
  /// From now on that takes what the robot senses in place of the maps, and hands on to them what
  /// is of the room; the atlas itself, to end that. It is removed before it is gone. After
  /// `begin_maps`.
  void put_before_maps(pipeline::ObservationSink& sink);
  /// What comes from here on is of the next session, behind one that was played.
  void begin_next_session() { sessions_.begin_next(); }
  /// Leaves the maps as they are from here on, and follows no more.
  void end_maps();
  /// Hands what the robot senses to the follower, before the maps; null is none.
  void follow(std::unique_ptr<Follower> follower);
  /// A person may take the robot over, before or in the midst of any motion, which then ends with
  /// kTakenOver once the person gives it back. The queue outlives this.
  void obey(OperatorQueue& queue, const OperatorParams& params, const OperatorHooks& hooks);
  /// No person has the robot any more, nor may take it over.
  void obey_nobody() { person_.reset(); }
  /// The way to the robot, which is not yet spoken to.
  void open(OpenedRobot robot);
  /// Connects the session and lets the follower begin. Throws as RobotSession::connect and
  /// Follower::begin do.
  void connect();
  /// Carries out one motion of the robot, or one decision about its maps. Throws std::logic_error
  /// before `begin_maps`.
  exploration::MotionResult execute(const exploration::Motion& motion);
  /// Carries out a motion of the robot, under the eyes of its self-check.
  exploration::MotionResult move(const exploration::Motion& motion);
  /// Ends a simulated robot; false where it ended without its truth, or is none.
  bool quit() { return lockstep_ && lockstep_->quit(); }

  const RobotProfile& profile() const { return profile_; }
  const Seed& seed() const { return seed_; }
  /// What the session is recorded by, from the beginning.
  recording::SessionRecorder& recorder() { return recorder_; }
  /// Where others listen to what the robot senses.
  pipeline::ObservationFork& fork() { return fork_; }
  /// Where the record of an earlier session is played, before the port is open.
  pipeline::JoinedSessions& sessions() { return sessions_; }
  /// After `begin_maps`.
  // NOLINTBEGIN(bugprone-unchecked-optional-access): callers begin the maps first
  pipeline::RobotAtlas& atlas() { return *atlas_; }
  const pipeline::RobotAtlas& atlas() const { return *atlas_; }
  // NOLINTEND(bugprone-unchecked-optional-access)
  /// Name of the SLAM method that places the robot, or kNoSlam. After `begin_maps`.
  const std::string& slam() const { return slam_; }
  bool is_followed() const { return follower_ != nullptr; }
  /// Null where no person is obeyed.
  const OperatorControl* person() const { return person_ ? &*person_ : nullptr; }
  /// How fast a simulated robot's time passes.
  TimeScale& time_scale() { return time_scale_; }
  /// What its first stops have shown to be wrong with the robot or its profile, or its encoders'
  /// errors, where these explain it.
  std::optional<diagnosis::Diagnosis> diagnosis() const;
  /// The wheel that stood still when its last motion stalled.
  std::optional<diagnosis::FaultKind> wheel_that_stood_still() const;
  /// An encoder that loses counts.
  const std::optional<diagnosis::Fault>& dirty_encoder() const { return encoder_check_.fault(); }
  /// The sonar has not answered its last triggers.
  bool sonar_is_dead() const { return sonar_check_.is_dead(); }
  bool is_open() const { return session_ != nullptr; }
  /// After `open`.
  RobotSession& session() {
    assert(is_open());
    return *session_;
  }
  const RobotSession& session() const {
    assert(is_open());
    return *session_;
  }
  /// The clock of a simulated robot; null for one on a desk.
  transport::LockstepChannel* lockstep() { return lockstep_.get(); }

  /// Calls a function after every step of the session's time, for as long as it exists.
  class StepListener {
   public:
    /// `robot` outlives this.
    StepListener(RobotContext& robot, std::function<void()> on_step)
        : listeners_(robot.listeners_),
          place_(listeners_.insert(listeners_.end(), std::move(on_step))) {}
    ~StepListener() { listeners_.erase(place_); }
    StepListener(const StepListener&) = delete;
    StepListener& operator=(const StepListener&) = delete;

   private:
    std::list<std::function<void()>>& listeners_;
    std::list<std::function<void()>>::iterator place_;
  };

 private:
  void step();
  /// Warns once where the recording cannot be written, where the sonar does not answer and of an
  /// encoder that loses counts.
  void look_for_trouble();
  /// Carries out what the person wants for as long as the person has the robot.
  exploration::MotionResult hand_over(OperatorControl& person);

  RobotProfile profile_;
  Seed seed_;
  bool trouble_is_reported_ = false;
  bool dead_sonar_is_reported_ = false;
  bool dirt_is_reported_ = false;
  recording::SessionRecorder recorder_;
  RecordingLog recording_log_{recorder_};
  pipeline::ObservationFork fork_;
  pipeline::JoinedSessions sessions_{fork_};
  std::optional<pipeline::RobotAtlas> atlas_;
  pipeline::ObservationSink* maps_ = nullptr;  ///< The atlas, or what is before it.
  std::string slam_;
  diagnosis::SonarCheck sonar_check_;
  diagnosis::EncoderCheck encoder_check_;
  std::optional<diagnosis::SelfCheck> self_check_;  ///< Of a robot with a sonar.
  std::unique_ptr<Follower> follower_;
  std::optional<OperatorControl> person_;
  std::list<std::function<void()>> listeners_;
  TimeScale time_scale_;
  std::unique_ptr<transport::LockstepChannel> lockstep_;
  std::function<void()> remember_port_;  ///< Of OpenedRobot.
  std::unique_ptr<RobotSession> session_;
};

/// The session's time, in seconds.
double now_s(const RobotSession& session);

}  // namespace echomap::session

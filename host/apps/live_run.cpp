// SPDX-License-Identifier: MIT
#include "host/apps/live_run.hpp"

#include <unistd.h>
#include <utility>
#include <variant>
#include <vector>

#include <spdlog/spdlog.h>

#include "host/apps/served_page.hpp"
#include "host/console/browser.hpp"
#include "host/live_page/foxglove_protocol.hpp"
#include "host/strategies/strategy_setup.hpp"

namespace echomap::apps {
namespace {

using live_page::RunState;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// The robot's motion is shown 25 times a second, and 10 times a second of its own time.
constexpr milliseconds kMotionPeriod(40);
constexpr double kMotionPeriodS = 0.1;
/// All else.
constexpr milliseconds kLookPeriod(200);
/// Frames are counted for so long.
constexpr std::chrono::seconds kCountPeriod(1);
/// Of a simulated robot that a person carries off, and the box that is put down.
constexpr std::chrono::seconds kHeld(2);
constexpr double kBoxSideM = 0.3;

live_page::RunState::Phase phase_of(const session::RobotSession& session, bool has_ended) {
  if (has_ended) {
    return RunState::Phase::kEnded;
  }
  switch (session.link().state()) {
    case robot_link::LinkState::kReady:
      return RunState::Phase::kRunning;
    case robot_link::LinkState::kLost:
      return RunState::Phase::kLostLink;
    default:
      return session.odometry_stamp_us() ? RunState::Phase::kLostLink
                                         : RunState::Phase::kConnecting;
  }
}

session::OperatorParams operator_params(const session::RobotProfile& profile) {
  session::OperatorParams params;
  params.navigator = strategies::navigator_params(profile);
  params.forward_m_per_s = profile.speed_m_per_s;
  params.turn_rad_per_s = 2.0 * profile.speed_m_per_s / profile.geometry.track_m;
  return params;
}

std::vector<std::string> commands_of(const PersonsWord& word, bool can_go, bool is_simulated) {
  std::vector<std::string> can{"stop", "drive", "explore"};
  if (can_go) {
    can.emplace_back("go");
  }
  if (word.moved) {
    can.emplace_back("moved");
  }
  if (word.placed) {
    can.emplace_back("pose");
  }
  if (is_simulated) {
    can.insert(can.end(), {"speed", "carry-off", "box", "cut-cable"});
  }
  return can;
}

/// With the time at which it comes, where that counts.
session::OperatorCommand stamped(session::OperatorCommand command) {
  if (auto* steer = std::get_if<session::SteerRobot>(&command)) {
    steer->at = steady_clock::now();
  }
  return command;
}

/// Another one for every run of the program, so that a client that connects again forgets the old.
std::string session_name() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::to_string(std::chrono::duration_cast<milliseconds>(now).count());
}

}  // namespace

LiveRun::LiveRun(const LiveOptions& options,
                 session::RobotContext& robot,
                 const LiveRunFacts& facts)
    : robot_(robot), is_simulated_(facts.is_simulated) {
  if (options.serves) {
    serve(options, facts);
    obey(facts);
    listener_.emplace(robot_, [this] { step(); });
  }
}

LiveRun::~LiveRun() {
  server_.reset();
  if (publisher_) {
    robot_.recorder().listen(nullptr);
    robot_.fork().remove(*publisher_);
    robot_.obey_nobody();
  }
}

void LiveRun::serve(const LiveOptions& options, const LiveRunFacts& facts) {
  const auto history = std::make_shared<live_page::History>();
  live_page::RunFacts run;
  run.name = facts.out.filename().string();
  run.version = ECHOMAP_VERSION;
  run.command = facts.command;
  run.live = true;
  run.has_truth = facts.is_simulated;
  run.can = commands_of({}, false, is_simulated_);
  publisher_ = std::make_shared<live_page::RunPublisher>(history, run, robot_.profile());
  topics_.emplace(session_name());
  server_ = serve_page(
      options,
      {{run.name, facts.out, history, true}},
      run.can,
      [this](const session::OperatorCommand& command) { queue_.push(stamped(command)); },
      live_page::foxglove_protocols(*topics_));
  robot_.fork().add(*publisher_);
  robot_.recorder().listen(&*topics_);
}

void LiveRun::obey(const LiveRunFacts& facts) {
  session::OperatorHooks hooks;
  hooks.on_moved = [this] {
    if (word_.moved) {
      word_.moved();
    }
  };
  hooks.on_placed = [this](const geometry::Pose2& T_map_robot) {
    if (word_.placed) {
      word_.placed(T_map_robot);
    }
  };
  hooks.on_speed = [this](double factor) { robot_.time_scale().set_factor(factor); };
  if (facts.is_simulated) {
    hooks.on_carry_off = [this] {
      robot_.lockstep()->carry_off(kHeld);
      tell({"carried-off", live_page::RunEvent::Level::kInfo, "somebody carries the robot off"});
    };
    hooks.on_box = [this](const Eigen::Vector2d& at_m) {
      robot_.lockstep()->put_box(at_m.x(), at_m.y(), kBoxSideM);
      tell({"box", live_page::RunEvent::Level::kInfo, "somebody puts a box down"});
    };
    hooks.on_cut_cable = [this](double for_s) {
      robot_.lockstep()->cut_cable(std::chrono::duration_cast<std::chrono::microseconds>(
          std::chrono::duration<double>(for_s)));
      tell({"cable-cut", live_page::RunEvent::Level::kInfo, "somebody pulls the cable out"});
    };
  }
  robot_.obey(queue_, operator_params(robot_.profile()), hooks);
}

void LiveRun::show(std::unique_ptr<LiveSource> source, const PersonsWord& word, bool can_go) {
  if (!server_) {
    return;
  }
  source_ = std::move(source);
  word_ = word;
  const std::vector<std::string> can = commands_of(word_, can_go, is_simulated_);
  server_->set_can(can);
  publisher_->set_can(time_s(), can);
}

bool LiveRun::may_be_watched() const {
  return serves() && (console::has_desktop() || ::isatty(STDERR_FILENO) == 1);
}

double LiveRun::time_s() const { return robot_.is_open() ? now_s(robot_.session()) : 0.0; }

void LiveRun::step() {
  const WallTime now = steady_clock::now();
  if (now >= next_motion_ || time_s() >= next_motion_s_) {
    next_motion_ = now + kMotionPeriod;
    next_motion_s_ = time_s() + kMotionPeriodS;
    const bool is_heard = robot_.session().link().state() == robot_link::LinkState::kReady;
    const auto pose = source_ && is_heard ? source_->pose() : std::nullopt;
    if (pose) {
      publisher_->add_motion(time_s(), *pose, true_pose());
    }
  }
  if (now >= next_look_) {
    next_look_ = now + kLookPeriod;
    look_around(now);
  }
}

void LiveRun::look() {
  if (server_) {
    score_map();
    look_around(steady_clock::now());
  }
}

void LiveRun::score_against(const std::filesystem::path& truth) {
  if (!server_) {
    return;
  }
  try {
    score_.emplace(truth);
  } catch (const files::FileError& error) {
    spdlog::warn("the live page shows no score: {}", error.what());
  }
}

void LiveRun::score_map() {
  if (!score_ || has_other_map_) {
    return;
  }
  const pipeline::Snapshot snapshot = robot_.atlas().pipeline().snapshot();
  if (std::exchange(scored_stops_, snapshot.stops) != snapshot.stops) {
    score_->look_at(*snapshot.grid);
  }
}

/// Once there is another map, nothing says where that lies in the room.
nlohmann::ordered_json LiveRun::score() const {
  const auto pose = source_ ? source_->pose() : std::nullopt;
  return score_ && pose && !has_other_map_ ? score_->json(pose->T_map_robot, true_pose())
                                           : nlohmann::ordered_json();
}

/// The map frame of a simulated robot's first map is its start pose, as that of its truth is.
std::optional<geometry::Pose2> LiveRun::true_pose() const {
  const auto* lockstep = robot_.lockstep();
  if (lockstep == nullptr || !lockstep->true_pose() || has_other_map_) {
    return std::nullopt;
  }
  const transport::TruePose& pose = *lockstep->true_pose();
  return geometry::Pose2(pose.x_m, pose.y_m, pose.heading_rad);
}

void LiveRun::look_around(WallTime now) {
  const std::uint64_t frames = robot_.session().link().statistics().frames_received;
  if (const std::chrono::duration<double> passed = now - counted_at_; passed >= kCountPeriod) {
    frames_per_s_ = static_cast<double>(frames - std::exchange(frames_, frames)) / passed.count();
    counted_at_ = now;
  }
  if (source_) {
    source_->publish(time_s(), *publisher_);
    source_->describe(progress_);
  }
  tell_events();
  if (const std::string trouble = server_->take_trouble(); !trouble.empty()) {
    spdlog::warn("the live page could not answer a client: {}", trouble);
  }
  publisher_->add_state(time_s(), state());
}

void LiveRun::tell_events() {
  live_page::EventFacts facts;
  facts.link = robot_.session().link().state();
  facts.resets = robot_.session().link().statistics().resets_seen;
  facts.is_touching = publisher_->hazards().is_touching();
  facts.is_lifted = publisher_->hazards().is_in_the_air();
  facts.sonar_is_dead = robot_.sonar_is_dead();
  if (const auto& dirt = robot_.dirty_encoder()) {
    facts.left_encoder_is_dirty = dirt->kind == diagnosis::FaultKind::kLeftDirty;
    facts.right_encoder_is_dirty = dirt->kind == diagnosis::FaultKind::kRightDirty;
  }
  facts.stands = robot_.person()->reason();
  if (source_) {
    source_->describe(facts);
  }
  has_other_map_ = has_other_map_ || facts.maps_changed > 0;
  for (const live_page::RunEvent& event : events_.look_at(facts)) {
    tell(event);
  }
}

RunState LiveRun::state() const {
  RunState state = progress_;
  state.phase = phase_of(robot_.session(), result_.has_value());
  state.person = robot_.person()->mode();
  state.stands = robot_.person()->reason();
  const live_page::PageAudience audience = server_->audience();
  state.clients = audience.clients;
  state.driver = audience.driver;
  state.driver_name = audience.driver_name;
  state.speed = robot_.lockstep() != nullptr ? robot_.time_scale().factor() : 1.0;
  if (!result_) {
    state.link = link_health();
  }
  state.score = score();
  state.result = result_;
  if (robot_.person()->has_robot()) {
    state.intent = {exploration::IntentKind::kPerson, std::nullopt, {}};
  }
  if (const auto goal_m = robot_.person()->goal_m()) {
    state.intent.goal = exploration::WeighedPlace{*goal_m, 0.0, 0.0};
  }
  return state;
}

live_page::LinkHealth LiveRun::link_health() const {
  const robot_link::RobotLink& link = robot_.session().link();
  return {link.state(), link.statistics(), frames_per_s_, publisher_->battery_v()};
}

void LiveRun::tell(const live_page::RunEvent& event) {
  if (server_) {
    publisher_->add_event(time_s(), event);
  }
}

void LiveRun::end(const RunEnding& ending) {
  if (!server_) {
    return;
  }
  show_nothing();
  server_->set_can({});
  publisher_->set_can(time_s(), {});
  progress_.intent = {};
  progress_.left_s.reset();
  result_ = live_page::RunResult{ending.finished(), ending.outcome, ending.why, ending.next};
  publisher_->add_state(time_s(), state());
  wait_while_watched(*server_);
}

}  // namespace echomap::apps

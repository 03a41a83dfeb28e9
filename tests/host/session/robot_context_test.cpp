// SPDX-License-Identifier: MIT
#include "host/session/robot_context.hpp"

#include <cstdint>
#include <memory>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/session/session_on_a_cable.hpp"

namespace echomap::session {
namespace {

/// Writes down what becomes of it, and how many stops the maps had at the end of a scan.
class Witness final : public Follower, public pipeline::ObservationSink {
 public:
  Witness(std::vector<std::string>& seen, RobotContext& robot) : seen_(seen), robot_(robot) {}

  pipeline::ObservationSink& sink() override { return *this; }
  void poll(const RobotSession& /*session*/) override { note("poll"); }
  void begin(RobotSession& session) override {
    note(session.link().state() == robot_link::LinkState::kReady ? "begin" : "begin too early");
  }
  void on_odometry(const sensors::OdometryObservation& /*observation*/) override {}
  void on_sonar(const sensors::SonarObservation& /*observation*/) override {}
  void begin_scan() override {}
  void end_scan() override {
    note("scan " + std::to_string(robot_.atlas().pipeline().snapshot().stops));
  }

 private:
  void note(const std::string& what) {
    if (seen_.empty() || seen_.back() != what) {
      seen_.push_back(what);
    }
  }

  std::vector<std::string>& seen_;
  RobotContext& robot_;
};

class RobotContextTest : public SessionOnACable {
 protected:
  RobotContextTest() { context.begin_maps("none"); }
  void open_and_connect() {
    context.open({new_connection(), nullptr});
    context.connect();
  }
  void stop() {
    context.execute(exploration::BeginScan{});
    context.execute(exploration::EndScan{});
  }
  std::size_t stops() const { return context.atlas().pipeline().snapshot().stops; }

  std::vector<std::string> seen;
  RobotContext context{profile, Seed(1)};
};

TEST_F(RobotContextTest, AFollowerSensesBeforeTheMapsAndIsPolledAtEveryStep) {
  context.follow(std::make_unique<Witness>(seen, context));
  EXPECT_TRUE(context.is_followed());
  int steps = 0;
  const RobotContext::StepListener listener(context, [&] { ++steps; });
  open_and_connect();
  stop();
  EXPECT_GT(steps, 0);
  EXPECT_EQ(seen, (std::vector<std::string>{"poll", "begin", "scan 0"}));
  EXPECT_EQ(stops(), 1U);
}

TEST_F(RobotContextTest, LeavesMapsThatHaveEndedAsTheyAre) {
  context.follow(std::make_unique<Witness>(seen, context));
  open_and_connect();
  stop();
  context.end_maps();
  seen.clear();
  stop();
  context.execute(exploration::Turn{0.5});
  EXPECT_EQ(stops(), 1U);
  EXPECT_TRUE(seen.empty());
  EXPECT_FALSE(context.is_followed());
}

TEST_F(RobotContextTest, CarriesOutWhatIsDecidedAboutTheMaps) {
  open_and_connect();
  stop();
  stop();
  EXPECT_EQ(context.execute(exploration::JoinMaps{}), exploration::MotionResult::kRefused);
  EXPECT_EQ(context.execute(exploration::BeginNewMap{1}), exploration::MotionResult::kReached);
  EXPECT_EQ(context.atlas().previous_maps().size(), 1U);
  EXPECT_EQ(stops(), 1U) << "the last is of the new map";
}

TEST_F(RobotContextTest, AMotionEndsAtOnceWherePersonTakesTheRobotAndReturnsWithIt) {
  OperatorQueue queue;
  OperatorParams params;
  params.forward_m_per_s = 0.2;
  context.obey(queue, params, {});
  open_and_connect();
  cable.robot.motion_ms = 60'000;
  std::vector<std::string> commands;
  cable.robot.on_command = [&](std::string_view name) { commands.emplace_back(name); };
  const double begin_s = now_s(context.session());
  double stopped_after_s = 0.0;
  const RobotContext::StepListener listener(context, [&, steps = 0]() mutable {
    ++steps;
    if (steps == 20) {
      queue.push(StopRobot{});
    }
    if (commands.size() == 2 && stopped_after_s == 0.0) {
      stopped_after_s = now_s(context.session()) - begin_s;
    }
    if (steps == 200) {
      queue.push(ResumeStrategy{});
    }
  });
  EXPECT_EQ(context.execute(exploration::Drive{5.0}), exploration::MotionResult::kTakenOver);
  EXPECT_EQ(commands, (std::vector<std::string>{"MoveTicks", "Stop"}));
  EXPECT_LT(stopped_after_s, 0.15) << "STOP comes after 0.1 s";
  EXPECT_GE(now_s(context.session()) - begin_s, 1.0) << "it stands until it is given back";
  cable.robot.on_command = nullptr;
}

TEST_F(RobotContextTest, ObeysNobodyAnyMore) {
  auto queue = std::make_unique<OperatorQueue>();
  context.obey(*queue, {}, {});
  open_and_connect();
  queue->push(StopRobot{});
  context.obey_nobody();
  queue.reset();
  EXPECT_EQ(context.person(), nullptr);
  EXPECT_EQ(context.execute(exploration::Drive{0.1}), exploration::MotionResult::kReached);
}

TEST_F(RobotContextTest, AStopDoesNotWaitForTheAnswerToTheMotion) {
  OperatorQueue queue;
  context.obey(queue, OperatorParams{}, {});
  open_and_connect();
  cable.robot.acknowledges = false;
  std::size_t zeros = 0;
  std::size_t alive_at_stop = 0;
  const RobotContext::StepListener listener(context, [&, steps = 0]() mutable {
    ++steps;
    if (steps == 4) {
      queue.push(StopRobot{});
      alive_at_stop = cable.robot.keep_alives.size();
    } else if (steps == 8) {
      for (const protocol::DriveSetpoint& setpoint : cable.robot.setpoints) {
        zeros += setpoint.left_ticks_per_s == 0 && setpoint.right_ticks_per_s == 0 ? 1 : 0;
      }
    } else if (steps == 40) {
      EXPECT_LE(cable.robot.keep_alives.size(), alive_at_stop + 1);
      cable.robot.acknowledges = true;
    } else if (steps == 100) {
      queue.push(ResumeStrategy{});
    }
  });
  EXPECT_EQ(context.execute(exploration::Drive{5.0}), exploration::MotionResult::kTakenOver);
  EXPECT_GE(zeros, 1U) << "within 20 ms";
}

TEST_F(RobotContextTest, ExecutesNothingBeforeItsMapsHaveBegun) {
  RobotContext without_maps(profile, Seed(1));
  without_maps.open({new_connection(), nullptr});
  EXPECT_THROW(without_maps.execute(exploration::Turn{0.5}), std::logic_error);
  EXPECT_THROW(without_maps.execute(exploration::JoinMaps{}), std::logic_error);
}

TEST_F(RobotContextTest, CannotEndARealRobot) {
  open_and_connect();
  EXPECT_EQ(context.lockstep(), nullptr);
  EXPECT_FALSE(context.quit());
  EXPECT_GT(now_s(context.session()), 0.0);
}

TEST(Seed, LetsTheStrategyRepeatThePublishedRuns) {
  EXPECT_EQ(Seed(7).generator(SeedPurpose::kStrategy), std::mt19937(7));
  EXPECT_EQ(Seed(7).number(), 7U);
}

TEST(Seed, GivesEveryPurposeAStreamOfItsOwn) {
  std::set<std::mt19937::result_type> firsts;
  for (const std::uint32_t number : {1U, 2U, 3U}) {
    for (const SeedPurpose purpose : {SeedPurpose::kStrategy, SeedPurpose::kLocalizer}) {
      auto random = Seed(number).generator(purpose);
      EXPECT_EQ(random, Seed(number).generator(purpose)) << "the same again";
      firsts.insert(random());
    }
  }
  EXPECT_EQ(firsts.size(), 6U);
}

}  // namespace
}  // namespace echomap::session

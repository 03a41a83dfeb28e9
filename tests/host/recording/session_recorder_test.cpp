// SPDX-License-Identifier: MIT
#include "host/recording/session_recorder.hpp"

#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "host/recording/session_messages.hpp"
#include "host/ros_messages/rcl_interfaces.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/mcap_records.hpp"
#include "tests/support/robot_times.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::recording {
namespace {

using tests::at_us;

class SessionRecorderTest : public ::testing::Test {
 protected:
  /// The messages of the recording, by topic.
  std::map<std::string, std::vector<mcap::Message>> messages() {
    recorder.open(scratch / "session.mcap");
    recorder.finish();
    std::map<std::string, std::vector<mcap::Message>> messages;
    for (const mcap::Message& message : tests::all_messages(scratch / "session.mcap")) {
      messages[message.channel->info.topic].push_back(message);
    }
    return messages;
  }
  template <class M>
  static M read(const mcap::Message& message) {
    EXPECT_EQ(message.channel->schema->name, M::kName);
    return ros_messages::deserialize<M>(message.data);
  }

  const tests::ScratchFolder scratch;
  SessionRecorder recorder{{{}, {0.2, 0.04, 2.0}, {{0.1, 0.0, 0.0}}, "pulses/s"}};
};

TEST_F(SessionRecorderTest, ShowsOthersWhatTheRobotSenses) {
  recorder.begin_session(1'000'000'000);
  recorder.set_time(time::HostTime(std::chrono::milliseconds(500)));
  recorder.on_odometry({at_us(7), {0.1, 0.1}});
  recorder.on_sonar({at_us(8), {0.1, 0.1}, 0.5, 1.0});
  recorder.on_infrared({at_us(9), {0.1, 0.1}, {0.3}});
  recorder.on_yaw({at_us(9), {1.0, 1.0, 0}});
  recorder.on_battery({at_us(9), 7.5});
  auto all = messages();
  EXPECT_EQ(all.at("/odom").at(0).log_time_ns, 1'500'000'000U);
  EXPECT_NEAR(read<ros_messages::Odometry>(all["/odom"][0]).pose.pose.position.x, 0.1, 1e-12);
  ASSERT_EQ(all.at("/tf").size(), 2U);
  const auto moved = read<ros_messages::TFMessage>(all["/tf"][0]);
  EXPECT_EQ(moved.transforms.at(0).header.frame_id, "map");
  EXPECT_EQ(moved.transforms.at(1).child_frame_id, "base_link");
  EXPECT_EQ(read<ros_messages::TFMessage>(all["/tf"][1]).transforms.at(0).child_frame_id, "sonar");
  EXPECT_EQ(read<ros_messages::Range>(all.at("/sonar").at(0)).range, 1.0F);
  EXPECT_EQ(all.at("/sonar/cone").size(), 1U);
  EXPECT_EQ(read<ros_messages::Range>(all.at("/infrared_0").at(0)).range, 0.3F);
  EXPECT_EQ(all.at("/tf_static").size(), 1U);
  EXPECT_EQ(all.at("/imu").size(), 1U);
  EXPECT_EQ(all.at("/battery").size(), 1U);
}

TEST_F(SessionRecorderTest, TellsPulsesAsTheirRateAndALevelAsItIs) {
  recorder.on_scalar({at_us(9), {0.1, 0.1}, 8.0, 0.25});
  recorder.on_scalar({at_us(9), {0.1, 0.1}, 3.5, 0.0});
  auto all = messages();
  const auto pulses = read<ScalarReadingMessage>(all.at("/scalar").at(0));
  EXPECT_EQ(pulses.unit, "pulses/s");
  EXPECT_EQ(pulses.value, 32.0);
  EXPECT_EQ(pulses.count, 8.0);
  EXPECT_EQ(pulses.dwell_s, 0.25);
  EXPECT_EQ(pulses.header.frame_id, "base_link");
  const auto level = read<ScalarReadingMessage>(all.at("/scalar").at(1));
  EXPECT_EQ(level.value, 3.5);
  EXPECT_EQ(level.count, 0.0);
}

TEST_F(SessionRecorderTest, OdometryTellsTheSpeed) {
  recorder.on_odometry({at_us(0), {0.0, 0.0}});
  recorder.on_odometry({at_us(100'000), {0.02, 0.02}});
  recorder.on_odometry({at_us(100'000), {0.03, 0.03}});
  auto all = messages();
  const auto speed_m_per_s = [&](std::size_t i) {
    return read<ros_messages::Odometry>(all.at("/odom").at(i)).twist.twist.linear.x;
  };
  EXPECT_EQ(speed_m_per_s(0), 0.0);
  EXPECT_NEAR(speed_m_per_s(1), 0.2, 1e-9);
  EXPECT_EQ(speed_m_per_s(2), 0.0) << "no time has passed";
}

TEST_F(SessionRecorderTest, ReportsContactsWhereTheyChange) {
  recorder.on_hazards({.stamp = at_us(1)});
  recorder.on_hazards({.stamp = at_us(2), .bump_left = true});
  recorder.on_hazards({.stamp = at_us(3), .bump_left = true});
  auto all = messages();
  ASSERT_EQ(all.at("/diagnostics").size(), 1U);
  const auto status = read<ros_messages::DiagnosticArray>(all["/diagnostics"][0]).status.at(0);
  EXPECT_EQ(status.level, ros_messages::DiagnosticStatus::kWarn);
  EXPECT_EQ(status.message, "touching");
}

TEST_F(SessionRecorderTest, EndsOnlyAScanThatIsOpen) {
  recorder.end_scan();
  recorder.begin_scan();
  recorder.end_scan();
  recorder.end_scan();
  auto all = messages();
  ASSERT_EQ(all.at("/session/events").size(), 2U);
  EXPECT_EQ(read<SessionEventMessage>(all["/session/events"][1]).kind, "end-scan");
}

TEST_F(SessionRecorderTest, ShowsTheMapAndWhereItHasTheRobot) {
  pipeline::RobotPipeline pipeline((sensors::RobotGeometry()));
  recorder.on_odometry({at_us(1), {0.5, 0.5}});
  pipeline.on_odometry({at_us(1), {0.5, 0.5}});
  pipeline.on_pose_fix({at_us(1), {2.0, 0.0, 0.0}});
  pipeline.begin_scan();
  pipeline.on_sonar({at_us(2), {0.5, 0.5}, 0.0, 1.0});
  pipeline.end_scan();
  recorder.add_map(pipeline.snapshot());
  recorder.on_odometry({at_us(3), {0.6, 0.6}});
  recorder.add_localization({1.0, 1.0, 0.0}, {{}, {}});
  recorder.add_log(ros_messages::Log::kWarn, "look");
  auto all = messages();
  EXPECT_EQ(all.at("/map").size(), 1U);
  EXPECT_EQ(all.at("/path").size(), 1U);
  EXPECT_EQ(all.at("/map/features").size(), 1U);
  EXPECT_EQ(all.at("/scan").size(), 1U);
  EXPECT_EQ(
      read<ros_messages::PoseWithCovarianceStamped>(all.at("/pose").at(0)).pose.pose.position.x,
      2.0);
  const auto odom = read<ros_messages::TFMessage>(all.at("/tf").back()).transforms.at(0);
  EXPECT_NEAR(odom.transform.translation.x, 1.5, 1e-12) << "from the map to odometry";
  EXPECT_EQ(read<ros_messages::PoseArray>(all.at("/particles").at(0)).poses.size(), 2U);
  EXPECT_EQ(read<ros_messages::Log>(all.at("/rosout").at(0)).msg, "look");
}

TEST_F(SessionRecorderTest, ALaterSessionBeginsBehindTheOneBefore) {
  recorder.begin_session(0);
  recorder.set_log_time(9'000'000'000);
  recorder.add_sent(std::vector<std::uint8_t>{1, 0});
  recorder.begin_session(0);
  recorder.set_time(time::HostTime(std::chrono::seconds(1)));
  recorder.add_sent(std::vector<std::uint8_t>{1, 0});
  auto all = messages();
  EXPECT_EQ(all.at("/session/events").at(1).log_time_ns, 9'000'000'000U);
  EXPECT_EQ(all.at("/robot/frames_sent").at(1).log_time_ns, 10'000'000'000U);
}

TEST_F(SessionRecorderTest, IsOfTheSameBytesForTheSameSession) {
  const auto record = [&](const char* name) {
    SessionRecorder one({});
    one.begin_session(0);
    for (int i = 0; i < 1000; ++i) {
      one.set_time(time::HostTime(std::chrono::milliseconds(20 * i)));
      one.on_odometry({at_us(i), {0.001 * i, 0.002 * i}});
    }
    one.open(scratch / name);
    one.finish();
    return files::read_text_file(scratch / name);
  };
  EXPECT_EQ(record("one"), record("other"));
}

/// Counts the messages of each topic.
class CountedTopics final : public TopicListener {
 public:
  void on_topic(const RecordedTopic& topic) override { names[topic.id] = topic.name; }
  void on_message(std::uint32_t topic,
                  std::uint64_t log_time_ns,
                  std::span<const std::uint8_t> bytes) override {
    messages[names.at(topic)].push_back({log_time_ns, {bytes.begin(), bytes.end()}});
  }

  std::map<std::uint32_t, std::string> names;
  std::map<std::string, std::vector<std::pair<std::uint64_t, std::vector<std::uint8_t>>>> messages;
};

TEST_F(SessionRecorderTest, AListenerHearsWhatIsRecordedAndChangesNothing) {
  const auto record = [&](const char* name, TopicListener* listener) {
    SessionRecorder one({});
    one.listen(listener);
    one.begin_session(1000);
    for (int i = 0; i < 10; ++i) {
      one.set_time(time::HostTime(std::chrono::milliseconds(20 * i)));
      one.on_odometry({at_us(i), {0.001 * i, 0.002 * i}});
      one.on_sonar({at_us(i), {0.001 * i, 0.002 * i}, 0.5, 1.0});
    }
    one.open(scratch / name);
    one.finish();
    return files::read_text_file(scratch / name);
  };
  CountedTopics listener;
  EXPECT_EQ(record("heard", &listener), record("unheard", nullptr));
  std::map<std::string, std::vector<std::pair<std::uint64_t, std::vector<std::uint8_t>>>> recorded;
  for (const mcap::Message& message : tests::all_messages(scratch / "heard")) {
    recorded[message.channel->info.topic].push_back({message.log_time_ns, message.data});
  }
  EXPECT_EQ(listener.messages, recorded);
}

TEST_F(SessionRecorderTest, GoesOnWhereTheDiskIsFullAndSaysWhy) {
  recorder.open(scratch / "session.mcap");
  const auto log_for = [&](int from_s, int to_s) {
    for (int i = from_s; i < to_s; ++i) {
      recorder.set_time(time::HostTime(std::chrono::seconds(i)));
      recorder.add_log(ros_messages::Log::kInfo, "line " + std::to_string(i));
    }
  };
  log_for(0, 10);
  EXPECT_EQ(recorder.trouble(), "");
  {
    const tests::FileSizeLimit limit(1000);
    log_for(10, 100);
    EXPECT_NE(recorder.trouble(), "");
  }
  log_for(100, 200);
  recorder.finish();
  EXPECT_EQ(tests::all_messages(scratch / "session.mcap").size(), 200U)
      << "nothing is lost where there is room again";
}

}  // namespace
}  // namespace echomap::recording

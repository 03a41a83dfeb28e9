// SPDX-License-Identifier: MIT
#include "host/session/session_player.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/pipeline/observation_log.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"
#include "tests/support/written_recording.hpp"

namespace echomap::session {
namespace {

using recording::SessionEventKind;
using ::testing::HasSubstr;

/// Notes stamps and travel of odometry, and fixes.
class Notes final : public pipeline::AnyObservationSink {
 public:
  void on(const sensors::Observation& observation) override {
    if (const auto* odometry = std::get_if<sensors::OdometryObservation>(&observation)) {
      stamps_us.push_back(odometry->stamp.time_since_epoch().count());
      left_m.push_back(odometry->travel.left_m);
    } else if (const auto* ping = std::get_if<sensors::SonarObservation>(&observation)) {
      answered.push_back(ping->has_answered);
    } else if (const auto* scalar = std::get_if<sensors::ScalarObservation>(&observation)) {
      scalars.push_back(*scalar);
    } else if (const auto* fix = std::get_if<sensors::PoseFixObservation>(&observation)) {
      fixes.push_back(*fix);
    }
  }

  std::vector<std::int64_t> stamps_us;
  std::vector<double> left_m;
  std::vector<bool> answered;
  std::vector<sensors::PoseFixObservation> fixes;
  std::vector<sensors::ScalarObservation> scalars;
};

class SessionPlayerTest : public ::testing::Test {
 protected:
  void play(double from_s = 0.0, double until_s = 1000.0) { play(profile, from_s, until_s); }
  void play(const RobotProfile& with, double from_s, double until_s) {
    recording.save(scratch / "session.mcap");
    recording::SessionReader reader(scratch / "session.mcap");
    pipeline::JoinedSessions sessions(notes);
    SessionPlayer player(reader, with, {sessions, notes});
    player.play_between(from_s, until_s);
    while (player.play_next()) {
    }
    observations = player.observations();
  }
  void odometry(std::uint32_t stamp_us, std::int16_t ticks, bool is_used = true) {
    recording.receive(protocol::Odometry{stamp_us, ticks, ticks, 0}, is_used);
  }

  const tests::ScratchFolder scratch;
  const RobotProfile profile = load_robot_profile("uno_2wd");
  tests::WrittenRecording recording{profile};
  Notes notes;
  std::size_t observations = 0;
};

TEST_F(SessionPlayerTest, PlaysOnlyTheFramesThatTheHostUsed) {
  odometry(1000, 0);
  odometry(2000, 100, false);
  odometry(3000, 200);
  play();
  EXPECT_EQ(notes.stamps_us, (std::vector<std::int64_t>{1000, 3000}));
}

TEST_F(SessionPlayerTest, StampsAndWheelsGoOnBehindAReset) {
  odometry(1'000'000, 1000);
  recording.add(SessionEventKind::kRobotReset, 500'000);
  odometry(20'000, 10);
  play();
  EXPECT_EQ(notes.stamps_us, (std::vector<std::int64_t>{1'000'000, 1'500'000}));
  EXPECT_GT(notes.left_m.at(1), notes.left_m.at(0));
}

TEST_F(SessionPlayerTest, ALaterSessionGoesOnWhereTheOneBeforeEnded) {
  odometry(1000, 1000);
  odometry(2000, 2000);
  recording.recorder().begin_session(0);
  odometry(7'000'000, 77);
  odometry(7'000'500, 1077);
  play();
  EXPECT_EQ(notes.stamps_us, (std::vector<std::int64_t>{1000, 2000, 2000, 2500}));
  EXPECT_NEAR(notes.left_m[3] - notes.left_m[2], notes.left_m[1] - notes.left_m[0], 1e-12);
}

TEST_F(SessionPlayerTest, OlderFirmwareSaysThatItsSonarIsSilentInItsOwnWay) {
  recording.add(SessionEventKind::kLinkReady, protocol::kNoSonarSinceMinor - 1);
  for (int i = 0; i < 100; ++i) {
    recording.receive(protocol::Echo{1000U * static_cast<unsigned>(i), 0, protocol::kNoEcho, 0, 0});
  }
  play();
  EXPECT_TRUE(notes.answered.front());
  EXPECT_FALSE(notes.answered.back());
}

TEST_F(SessionPlayerTest, HandsOnFixesToTheBit) {
  recording.recorder().add_event({SessionEventKind::kPoseFix, 17, {0.1, 1.0 / 3.0, -2.0}});
  play();
  ASSERT_EQ(notes.fixes.size(), 1U);
  EXPECT_EQ(notes.fixes[0].stamp.time_since_epoch().count(), 17);
  EXPECT_EQ(notes.fixes[0].T_map_robot.y_m(), 1.0 / 3.0);
  EXPECT_EQ(notes.fixes[0].T_map_robot.heading_rad(), -2.0);
}

TEST_F(SessionPlayerTest, HandsOnReadingsOfAScalarSensorAsTheSessionHadThem) {
  const RobotProfile with_tube = load_robot_profile("uno_geiger");
  Notes live;
  ObservationFeed feed(with_tube, live);
  for (const protocol::Scalar& message : {protocol::Scalar{100'007, 0, 0, 70, 0},
                                          protocol::Scalar{200'011, 250, 249, 73, 0},
                                          protocol::Scalar{500'013, 333, 331, 101, 0}}) {
    recording.receive(message);
    feed.take(message);
  }
  play(with_tube, 0.0, 1000.0);
  ASSERT_EQ(live.scalars.size(), 2U);
  ASSERT_EQ(notes.scalars.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(notes.scalars[i].stamp, live.scalars[i].stamp);
    EXPECT_EQ(notes.scalars[i].travel.left_m, live.scalars[i].travel.left_m);
    EXPECT_EQ(notes.scalars[i].count, live.scalars[i].count);
    EXPECT_EQ(notes.scalars[i].dwell_s, live.scalars[i].dwell_s);
  }
  EXPECT_EQ(notes.scalars[1].count, 28.0);
}

TEST_F(SessionPlayerTest, EndsWhereTheMapsDo) {
  odometry(1000, 0);
  recording.add(SessionEventKind::kEndMaps);
  odometry(2000, 0);
  play();
  EXPECT_EQ(notes.stamps_us.size(), 1U);
}

TEST_F(SessionPlayerTest, LeavesOutWhatComesBeforeItsBegin) {
  odometry(1000, 0);
  odometry(2000, 0);
  odometry(3000, 0);
  play(0.009);
  EXPECT_EQ(notes.stamps_us, (std::vector<std::int64_t>{2000, 3000}));
  notes.stamps_us.clear();
  play(0.0, 0.011);
  EXPECT_EQ(notes.stamps_us, (std::vector<std::int64_t>{1000, 2000}));
}

TEST_F(SessionPlayerTest, NamesAFrameThatItCannotRead) {
  recording.pass(std::chrono::milliseconds(1500));
  recording.recorder().add_received(std::vector<std::uint8_t>{3, 1, 2, 0}, 5);
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { play(); }),
              HasSubstr("the robot's frame at 1.500 s cannot be read"));
}

}  // namespace
}  // namespace echomap::session

// SPDX-License-Identifier: MIT
#include "host/apps/run_keeper.hpp"

#include <gtest/gtest.h>

#include "host/apps/saved_map.hpp"
#include "host/exports/observations_csv.hpp"
#include "host/files/atomic_file.hpp"
#include "host/strategies/strategy_setup.hpp"
#include "tests/host/session/session_on_a_cable.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::apps {
namespace {

/// Has made nothing of its own.
class Idler final : public exploration::Explorer {
 public:
  exploration::Motion next(const pipeline::Snapshot& /*snapshot*/,
                           exploration::MotionResult /*last*/) override {
    return exploration::Finished{};
  }
};

class RunKeeperTest : public session::SessionOnACable {
 protected:
  void stop() {
    atlas.on_odometry({stamp += std::chrono::milliseconds(20), {}});
    atlas.begin_scan();
    atlas.end_scan();
  }

  pipeline::RobotAtlas atlas = session::atlas_for(profile, "none");
  time::RobotTime stamp;
  Idler explorer;
  const tests::ScratchFolder out;
  exports::RunSummary summary;
};

TEST_F(RunKeeperTest, AMapThatWasSetAsideHasARunDirectoryOfItsOwn) {
  const DrivenRobot robot{*session, atlas, profile};
  RunKeeper keeper(robot, explorer, out.path(), summary);
  stop();
  keeper.save("exploring");
  EXPECT_FALSE(exists(out / "former_1"));
  stop();
  stop();
  atlas.begin_anew(2);
  keeper.save("complete");
  EXPECT_EQ(summary.outcome, "complete");
  EXPECT_EQ(summary.former_maps, 1U);
  EXPECT_EQ(summary.stops, 1U);
  EXPECT_EQ(files::read_text_file(out / "former_1/observations.csv"),
            "kind,stamp_us,values\nodometry,20000,0,0\nbegin-scan\nend-scan\n");
  EXPECT_TRUE(exists(out / "former_1/map.png"));
}

TEST_F(RunKeeperTest, TheRecordIsThatOfTheMapAfterEveryStop) {
  const DrivenRobot robot{*session, atlas, profile};
  RunKeeper keeper(robot, explorer, out.path(), summary);
  const auto expect_saved = [&](const char* when) {
    keeper.save("exploring");
    exports::ObservationRecorder recorder;
    atlas.record().replay(recorder);
    recorder.save(out / "expected.csv");
    EXPECT_EQ(files::read_text_file(out / kRecordName), files::read_text_file(out / "expected.csv"))
        << when;
  };
  expect_saved("at the start");
  stop();
  expect_saved("after a stop");
  stop();
  stop();
  expect_saved("after two more");
  atlas.begin_anew(2);
  stop();
  expect_saved("in another map");
  stop();
  expect_saved("after a stop there");
}

TEST_F(RunKeeperTest, AMapThatCouldNotBeSavedIsSavedTheNextTime) {
  const DrivenRobot robot{*session, atlas, profile};
  RunKeeper keeper(robot, explorer, out.path(), summary);
  stop();
  keeper.save_in_passing();
  files::write_text_file(out / "former_1", "in the way");
  stop();
  stop();
  atlas.begin_anew(2);
  keeper.save_in_passing();
  EXPECT_EQ(files::read_text_file(out / "former_1"), "in the way");
  std::filesystem::remove(out / "former_1");
  keeper.save("complete");
  EXPECT_TRUE(exists(out / "former_1/observations.csv"));
}

TEST_F(RunKeeperTest, WhatAFormerRunHasLeftStaysBesideIt) {
  files::write_text_file(out / kRecordName, "old");
  std::filesystem::create_directories(out / "former_1");
  files::write_text_file(out / "former_1/map.png", "old");
  const DrivenRobot robot{*session, atlas, profile};
  RunKeeper keeper(robot, explorer, out.path(), summary);
  keeper.save("exploring");
  keeper.save("complete");
  EXPECT_EQ(files::read_text_file(out / kFormerRecordName), "old");
  EXPECT_EQ(files::read_text_file(out / "former_1.before/map.png"), "old");
  EXPECT_FALSE(exists(out / "former_1"));
}

}  // namespace
}  // namespace echomap::apps

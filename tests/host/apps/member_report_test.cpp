// SPDX-License-Identifier: MIT
#include "host/apps/member_report.hpp"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/support/ideal_robot.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::apps {
namespace {

fleet_member::JoinLog log_of_a_join() {
  team_map::TeamMap team;
  team.take(tests::ideal_record("a.0", tests::room_of_posts(), tests::one_round_m(), 0.0));
  team.take(tests::ideal_record("b.0", tests::room_of_posts(), tests::other_round_m(), 1.0));
  team.set_known_pose({"a.0", "b.0", {geometry::Pose2(2.0, 1.0, 1.0), 0.1, 0.02}});
  team.update();
  fleet_member::JoinLog log;
  log.look(12.5, "a.0", team);
  log.look(20.0, "a.1", team);
  return log;
}

TEST(MemberReport, IsReadAsItWasWritten) {
  const fleet_member::JoinLog log = log_of_a_join();
  MemberEncounters encounters;
  encounters.add({.waits = 3, .bumps = 1, .deadlocks = 2}, true);
  encounters.add({.waits = 1, .made_way = 4, .without_place = 5}, false);
  const tests::ScratchFolder folder;
  nlohmann::ordered_json summary{{"outcome", "complete"}, {"sim_seconds", 61.5}, {"stops", 7}};
  summary["team"] = team_report(log, encounters);
  files::write_text_file(folder / "summary.json", summary.dump());
  const MemberReport member = read_member_report("a", folder.path());
  EXPECT_EQ(member.robot, "a");
  EXPECT_EQ(member.outcome, "complete");
  EXPECT_EQ(member.sim_seconds, 61.5);
  EXPECT_EQ(member.stops, 7U);
  ASSERT_EQ(member.joins.size(), 1U);
  EXPECT_EQ(member.joins[0].own_map, "a.0");
  EXPECT_EQ(member.joins[0].peer_map, "b.0");
  EXPECT_EQ(member.joins[0].from_s, 12.5);
  EXPECT_EQ(member.joins[0].until_s, 20.0);
  EXPECT_EQ(member.joins[0].T_own_peer.x_m(), log.joins()[0].T_own_peer.x_m());
  EXPECT_EQ(member.encounters.counts.waits, 4U);
  EXPECT_EQ(member.encounters.counts.bumps, 1U);
  EXPECT_EQ(member.encounters.counts.deadlocks, 2U);
  EXPECT_EQ(member.encounters.counts.made_way, 4U);
  EXPECT_EQ(member.encounters.counts.without_place, 5U);
  EXPECT_FALSE(member.encounters.ended_in_deadlock);
}

TEST(MemberReport, OfARunThatWasKilledNamesTheFile) {
  const tests::ScratchFolder folder;
  EXPECT_THROW(read_member_report("a", folder.path()), files::FileError);
  files::write_text_file(folder / "summary.json", R"({"outcome": "exploring"})");
  try {
    read_member_report("a", folder.path());
    FAIL() << "it has no team";
  } catch (const files::FileError& error) {
    EXPECT_NE(std::string(error.what()).find("summary.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace echomap::apps

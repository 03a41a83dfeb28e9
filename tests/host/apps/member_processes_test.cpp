// SPDX-License-Identifier: MIT
#include "host/apps/member_processes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/eventually.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::apps {
namespace {

using testing::ElementsAre;

class MemberProcessesTest : public testing::Test {
 protected:
  void start(const std::string& name, const std::string& script) {
    members_.start(name, {"/bin/sh", "-c", script}, folder_.path() / name);
  }
  void wait_for_b() {
    EXPECT_TRUE(tests::eventually([&] {
      members_.go_on();
      return !members_.exits()["b"].is_null();
    }));
  }
  static fleet::FleetState heard(const std::vector<std::string>& names) {
    fleet::FleetState state;
    for (const std::string& name : names) {
      fleet::FleetRobot robot;
      robot.name = name;
      robot.has_reported = true;
      state.robots.push_back(robot);
    }
    return state;
  }

  tests::ScratchFolder folder_;
  MemberProcesses members_;
};

TEST_F(MemberProcessesTest, EndEachByItself) {
  start("a", "exit 0");
  start("b", "exit 8");
  members_.wait_for_all();
  EXPECT_FALSE(members_.go_on());
  EXPECT_THAT(members_.unfinished(), ElementsAre("b (exit 8)"));
  EXPECT_FALSE(members_.has_lost_one());
  EXPECT_EQ(members_.exits().dump(), R"({"a":0,"b":8})");
}

TEST_F(MemberProcessesTest, NameFirstWhoEndedByItself) {
  start("a", "exec sleep 60");
  start("b", "exit 1");
  wait_for_b();
  EXPECT_TRUE(members_.go_on());
  EXPECT_EQ(members_.exits()["a"], nullptr);
  members_.interrupt();
  members_.wait_for_all();
  EXPECT_THAT(members_.unfinished(), ElementsAre("b (exit 1)", "a (exit 143)"));
  EXPECT_TRUE(members_.has_lost_one());
}

TEST_F(MemberProcessesTest, WaitForNobodyWhoDiedBeforeItWasHeard) {
  start("a", "exec sleep 60");
  start("b", "exit 0");
  EXPECT_FALSE(members_.has_lost_one_unheard({})) << "both may be on their way";
  wait_for_b();
  EXPECT_FALSE(members_.has_lost_one_unheard(heard({"a", "b"})));
  EXPECT_TRUE(members_.has_lost_one_unheard(heard({"a"})));
  members_.interrupt();
  members_.wait_for_all();
}

}  // namespace
}  // namespace echomap::apps

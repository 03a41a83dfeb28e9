// SPDX-License-Identifier: MIT
#include "host/session/recording_log.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include "host/ros_messages/rcl_interfaces.hpp"
#include "host/ros_messages/serialization.hpp"
#include "tests/support/mcap_records.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::session {
namespace {

TEST(RecordingLogTest, RecordsLinesWhileItExists) {
  const tests::ScratchFolder scratch;
  recording::SessionRecorder recorder({});
  {
    const RecordingLog log(recorder);
    spdlog::warn("a wheel {}", "slips");
    spdlog::error("lost");
  }
  spdlog::warn("nobody records this");
  recorder.open(scratch / "session.mcap");
  recorder.finish();
  std::vector<ros_messages::Log> lines;
  for (const mcap::Message& message : tests::all_messages(scratch / "session.mcap")) {
    lines.push_back(ros_messages::deserialize<ros_messages::Log>(message.data));
  }
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].msg, "a wheel slips");
  EXPECT_EQ(lines[0].level, ros_messages::Log::kWarn);
  EXPECT_EQ(lines[1].level, ros_messages::Log::kError);
}

}  // namespace
}  // namespace echomap::session

// SPDX-License-Identifier: MIT
#include "tests/benchmarks/fleet_record.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/fleet_messages/payload.hpp"
#include "host/mcap/mcap_writer.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::bench {
namespace {

using fleet_messages::ClaimMessage;
using fleet_messages::ClockMessage;
using fleet_messages::MessageBody;
using fleet_messages::PoseMessage;

/// A file of messages of one robot, as `fleet record` writes them.
class RecordFile {
 public:
  explicit RecordFile(const std::filesystem::path& path) : writer_({"ros2", "echomap"}) {
    writer_.open(path);
  }
  void add(const std::string& topic, const MessageBody& body) {
    const auto payload = fleet_messages::encode({{"robot0", 1, ++counter_}, body});
    ASSERT_TRUE(payload);
    const auto channel = writer_.add_channel({topic, 0, "echomap.fleet.v1", {}});
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(payload->data());
    writer_.write(channel, 0, 0, {bytes, payload->size()});
    sizes.push_back(payload->size());
  }
  void finish() { writer_.finish(); }

  std::vector<std::size_t> sizes;

 private:
  mcap::McapWriter writer_;
  std::uint32_t counter_ = 0;
};

PoseMessage pose_at(std::uint64_t stamp_ms) {
  PoseMessage pose;
  pose.stamp_ms = stamp_ms;
  return pose;
}

TEST(FleetRecord, MessagesAreAsTheyWereAtTheTimeOfTheRobotsLatestPose) {
  const tests::ScratchFolder folder;
  RecordFile file(folder / "fleet.mcap");
  file.add("/robot0/pose", pose_at(2000));
  file.add("/robot0/clock", ClockMessage());
  file.add("/robot0/claim", ClaimMessage());
  file.add("/robot0/pose", pose_at(3000));
  file.finish();
  const LoadRecord record = read_fleet_record(folder / "fleet.mcap");
  EXPECT_EQ(record.duration_s, 3.0);
  ASSERT_EQ(record.robots.size(), 1U);
  const auto& messages = record.robots[0];
  ASSERT_EQ(messages.size(), 3U) << "without the round";
  EXPECT_EQ(messages[0].kind, "pose");
  EXPECT_EQ(messages[0].delivery, mqtt::Delivery::kAtMostOnce);
  EXPECT_FALSE(messages[0].retain);
  EXPECT_EQ(messages[1].kind, "claim");
  EXPECT_EQ(messages[1].at_s, 2.0);
  EXPECT_EQ(messages[1].bytes, file.sizes[2]);
  EXPECT_EQ(messages[1].delivery, mqtt::Delivery::kAtLeastOnce);
  EXPECT_EQ(messages[2].at_s, 3.0);
}

TEST(FleetRecord, AFileWithoutAPoseIsNoRecord) {
  const tests::ScratchFolder folder;
  RecordFile file(folder / "fleet.mcap");
  file.add("/robot0/claim", ClaimMessage());
  file.finish();
  EXPECT_THROW(read_fleet_record(folder / "fleet.mcap"), files::FileError);
}

}  // namespace
}  // namespace echomap::bench

// SPDX-License-Identifier: MIT
/// Bulk reads from the release images: what they are described by stands in their flash.
#include <cstdint>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/config_digest.hpp"
#include "protocol/schema_description.hpp"
#include "tests/hil/on_every_board.hpp"
#include "tests/support/bulk_content.hpp"

namespace echomap::tests {
namespace {

using protocol::BulkContent;
using protocol::BulkData;

constexpr int kWindow = 4;
constexpr auto kDescription = protocol::describe_schema<protocol::AllMessages>();

/// Asks four at a time; a piece that does not come within 2 s throws.
std::vector<std::uint8_t> read_all(RobotSession& robot, BulkContent content) {
  BulkBuffer buffer;
  for (std::uint16_t offset = 0; offset == 0 || offset < buffer.total();) {
    robot.forget_heard();
    for (int i = 0; i < kWindow; ++i) {
      robot.send(protocol::BulkRead{static_cast<std::uint8_t>(content), offset});
      offset = static_cast<std::uint16_t>(offset + protocol::kBulkBytes);
    }
    if (!robot.run_until([&] { return robot.all<BulkData>().size() == kWindow; }, 2000)) {
      throw std::runtime_error("a piece is missing");
    }
    for (const BulkData& data : robot.all<BulkData>()) {
      buffer.add(data);
    }
  }
  return buffer.bytes();
}

class BulkReads : public OnEveryBoard {};

INSTANTIATE_TEST_SUITE_P(Boards, BulkReads, every_board(), image_label);

TEST_P(BulkReads, BringTheSchemaWhileTelemetryGoesOn) {
  ASSERT_TRUE(robot.connect());
  robot.run_ms(1000);
  const std::int64_t from_ns = robot.board().now_ns();
  const std::vector<std::uint8_t> expected(std::begin(kDescription.bytes),
                                           std::end(kDescription.bytes));
  EXPECT_EQ(read_all(robot, BulkContent::kSchema), expected);
  std::printf("%s: %zu bytes of schema in %.2f s\n",
              GetParam(),
              expected.size(),
              double(robot.board().now_ns() - from_ns) * 1e-9);
}

TEST_P(BulkReads, BringTheConfigurationOfTheDigest) {
  const auto reply = robot.connect();
  ASSERT_TRUE(reply);
  protocol::ConfigurationBytes bytes{};
  const std::vector<std::uint8_t> content = read_all(robot, BulkContent::kConfiguration);
  ASSERT_EQ(content.size(), sizeof(bytes.bytes));
  std::copy(content.begin(), content.end(), bytes.bytes);
  protocol::Configuration configuration{};
  ASSERT_TRUE(protocol::read_configuration(bytes, configuration));
  EXPECT_EQ(protocol::config_digest(configuration), reply->config_digest);
  EXPECT_EQ(configuration.drive.max_ticks_per_s, 3000);

  configuration.sonar.ping_gap_ms = 77;
  ASSERT_EQ(robot.command(configuration.sonar), protocol::CommandStatus::kAccepted);
  EXPECT_EQ(robot.connect()->config_digest, protocol::config_digest(configuration));
}

}  // namespace
}  // namespace echomap::tests

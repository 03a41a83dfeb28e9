// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_identification.hpp"

#include <algorithm>

#include "protocol/version.hpp"

namespace echomap::robot_link {

RobotIdentity RobotIdentification::identify(const protocol::HelloReply& robot) {
  if (robot.protocol_major != protocol::kProtocolMajor) {
    return refuse(robot, "");
  }
  if (speaks_our_protocol(robot)) {
    difference_.reset();
    return RobotIdentity::kUnderstood;
  }
  return difference_ && described_digest_ == robot.schema_digest ? RobotIdentity::kUnderstood
                                                                 : RobotIdentity::kUndescribed;
}

RobotIdentity RobotIdentification::identify(const protocol::HelloReply& robot,
                                            const BulkResult& description) {
  const auto schema = description.status == BulkStatus::kWhole
                          ? read_robot_schema(description.bytes)
                          : std::nullopt;
  if (!schema || digest_of(*schema) != robot.schema_digest) {
    return refuse(robot, "");
  }
  const SchemaDifference& difference = difference_.emplace(*schema);
  described_digest_ = robot.schema_digest;
  const bool has_all =
      std::ranges::all_of(needed_messages_, [&](auto id) { return difference.agrees(id); });
  return has_all ? RobotIdentity::kUnderstood : refuse(robot, difference.summary());
}

RobotIdentity RobotIdentification::refuse(const protocol::HelloReply& robot,
                                          const std::string& difference) {
  mismatch_ = mismatch_with(robot);
  mismatch_->difference = difference;
  return RobotIdentity::kRefused;
}

}  // namespace echomap::robot_link

// SPDX-License-Identifier: MIT
#include "host/robot_link/protocol_mismatch.hpp"

#include <iomanip>
#include <sstream>
#include <tuple>

#include "protocol/messages.hpp"
#include "protocol/version.hpp"

namespace echomap::robot_link {
namespace {

std::string version_text(unsigned major, unsigned minor, std::uint32_t digest) {
  std::ostringstream text;
  text << "protocol " << major << '.' << minor << " (schema " << std::hex << std::setw(8)
       << std::setfill('0') << digest << ')';
  return text.str();
}

}  // namespace

SideToUpdate ProtocolMismatch::side_to_update() const {
  const bool robot_is_newer = std::tie(robot_major, robot_minor) > std::tie(host_major, host_minor);
  return robot_is_newer ? SideToUpdate::kHost : SideToUpdate::kFirmware;
}

std::string ProtocolMismatch::next_step() const {
  if (side_to_update() == SideToUpdate::kHost) {
    return "this host is older: git pull, then ./run build";
  }
  const bool is_older = std::tie(robot_major, robot_minor) < std::tie(host_major, host_minor);
  return is_older ? "the robot is older: ./run flash"
                  : "both are of one version, built from different messages: ./run flash";
}

std::string ProtocolMismatch::message() const {
  std::ostringstream text;
  text << "the robot's firmware " << protocol::VersionText(robot_firmware_version).text()
       << " speaks " << version_text(robot_major, robot_minor, robot_digest) << ", this host "
       << version_text(host_major, host_minor, host_digest) << (difference.empty() ? "" : ": ")
       << difference << "\n  next: " << next_step();
  return text.str();
}

bool speaks_our_protocol(const protocol::HelloReply& reply) {
  return reply.protocol_major == protocol::kProtocolMajor &&
         reply.schema_digest == protocol::kSchemaDigest;
}

std::vector<std::uint8_t> messages_for_mapping() {
  return {protocol::Ack::kId,
          protocol::Arm::kId,
          protocol::Stop::kId,
          protocol::ConfigureDrive::kId,
          protocol::ConfigureSonar::kId,
          protocol::ConfigurePan::kId,
          protocol::ConfigurePins::kId,
          protocol::ConfigureSensors::kId,
          protocol::ConfigureSafety::kId,
          protocol::MoveTicks::kId,
          protocol::StartSweep::kId,
          protocol::KeepAlive::kId,
          protocol::Odometry::kId,
          protocol::Echo::kId,
          protocol::Status::kId};
}

ProtocolMismatch mismatch_with(const protocol::HelloReply& reply) {
  return {.host_major = protocol::kProtocolMajor,
          .host_minor = protocol::kProtocolMinor,
          .host_digest = protocol::kSchemaDigest,
          .robot_major = reply.protocol_major,
          .robot_minor = reply.protocol_minor,
          .robot_digest = reply.schema_digest,
          .robot_firmware_version = reply.firmware_version,
          .difference = {}};
}

}  // namespace echomap::robot_link

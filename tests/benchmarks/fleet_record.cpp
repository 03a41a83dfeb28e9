// SPDX-License-Identifier: MIT
#include "tests/benchmarks/fleet_record.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "host/files/atomic_file.hpp"
#include "host/fleet_messages/payload.hpp"
#include "host/mcap/mcap_reader.hpp"
#include "host/session/child_process.hpp"
#include "tests/support/eventually.hpp"

namespace echomap::bench {
namespace {

namespace fs = std::filesystem;
using fleet_messages::FleetMessage;
using fleet_messages::TopicKind;

/// A robot as it is read.
struct RecordedRobot {
  double now_s = 0.0;
  std::vector<RecordedMessage> messages;
};

void add(const FleetMessage& message, std::size_t bytes, RecordedRobot& robot) {
  if (const auto* pose = std::get_if<fleet_messages::PoseMessage>(&message.body)) {
    robot.now_s = 1e-3 * static_cast<double>(pose->stamp_ms);
  }
  const TopicKind kind = kind_of(message.body);
  if (kind == TopicKind::kClock) {
    return;
  }
  std::string name(name_of(kind));
  if (kind == TopicKind::kSubmap || kind == TopicKind::kSource) {
    name += "/" + std::to_string(robot.messages.size());
  }
  robot.messages.push_back(
      {robot.now_s,
       name,
       bytes,
       kind == TopicKind::kPose ? mqtt::Delivery::kAtMostOnce : mqtt::Delivery::kAtLeastOnce,
       is_retained(kind)});
}

/// "/robot0/pose": robot0.
std::string robot_of(const std::string& topic) { return topic.substr(1, topic.find('/', 1) - 1); }

}  // namespace

LoadRecord read_fleet_record(const fs::path& file) {
  mcap::McapReader reader(file);
  std::map<std::string, RecordedRobot> robots;
  while (const auto record = reader.next()) {
    const auto* message = std::get_if<mcap::Message>(&*record);
    if (message == nullptr || message->channel->info.message_encoding != "echomap.fleet.v1") {
      continue;
    }
    const std::string_view payload(reinterpret_cast<const char*>(message->data.data()),
                                   message->data.size());
    const auto decoded = fleet_messages::decode(payload);
    if (const auto* told = std::get_if<FleetMessage>(&decoded)) {
      add(*told, payload.size(), robots[robot_of(message->channel->info.topic)]);
    }
  }
  LoadRecord record;
  for (auto& [name, robot] : robots) {
    if (robot.now_s > 0.0) {
      record.duration_s = std::max(record.duration_s, robot.now_s);
      record.robots.push_back(std::move(robot.messages));
    }
  }
  if (record.robots.empty()) {
    throw files::FileError(file.string() + ": no robot has told a pose in it");
  }
  return record;
}

fs::path record_a_fleet(const fs::path& folder) {
  const fs::path program = session::program_folder() / "echomap";
  const fs::path out = folder / "fleet";
  const fs::path record = folder / "fleet.mcap";
  const fs::path watch = out / "broker" / "members" / "watch.toml";
  session::ChildProcess fleet({program,
                               "fleet",
                               "start",
                               "--robots=2",
                               "--world=l_room",
                               "--emulator=mock",
                               "--headless",
                               "--seed=3",
                               "--force",
                               "--out=" + out.string()},
                              folder / "fleet.log");
  if (!tests::eventually([&] { return fs::exists(watch) || fleet.exit_status(); })) {
    throw std::runtime_error("the fleet to record has no broker");
  }
  session::ChildProcess recorder(
      {program, "fleet", "record", "--as=" + watch.string(), "--force", "--out=" + record.string()},
      folder / "record.log");
  if (!fleet.wait_for(std::chrono::minutes(10))) {
    throw std::runtime_error("the fleet to record does not end");
  }
  recorder.send(SIGINT);
  if (recorder.wait_for(std::chrono::minutes(1)) != 0) {
    throw std::runtime_error("nothing was recorded: " +
                             files::read_text_file(folder / "record.log"));
  }
  return record;
}

}  // namespace echomap::bench

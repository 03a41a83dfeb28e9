// SPDX-License-Identifier: MIT
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "host/apps/commands.hpp"
#include "host/apps/fleet_watch.hpp"
#include "host/console/interrupt.hpp"
#include "host/console/print.hpp"
#include "host/fleet_messages/topic.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/mcap/mcap_writer.hpp"
#include "host/recording/map_messages.hpp"
#include "host/ros_messages/message_definition.hpp"
#include "host/ros_messages/serialization.hpp"

namespace echomap::apps {
namespace {

/// How often the joined map is written, seconds.
constexpr double kMapPeriodS = 5.0;

/// One file of what a fleet says: its messages as they are on the bus, and what they come to, as
/// messages of ROS 2 that viewers show.
class FleetRecorder {
 public:
  explicit FleetRecorder(const std::filesystem::path& file) : writer_({"ros2", "echomap"}) {
    writer_.open(file);
  }

  void add(const mqtt::Message& message, std::uint64_t time_ns) {
    const auto [channel, is_new] = channels_.try_emplace(topic_of(message.topic), 0);
    if (is_new) {
      channel->second = writer_.add_channel({channel->first, 0, "echomap.fleet.v1", {}});
    }
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(message.payload.data());
    writer_.write(channel->second, time_ns, time_ns, {bytes, message.payload.size()});
    ++messages_;
  }

  void add_map(const mapping::RasterMap& map, std::uint64_t time_ns) {
    const auto message = recording::map_message(time_ns, map);
    const auto [channel, is_new] = channels_.try_emplace("/map", 0);
    if (is_new) {
      ros_messages::MessageDefinitions definitions;
      definitions.add<ros_messages::OccupancyGrid>();
      const std::uint16_t schema = writer_.add_schema(
          {std::string(ros_messages::OccupancyGrid::kName), "ros2msg", definitions.text()});
      channel->second = writer_.add_channel({"/map", schema, "cdr", {}});
    }
    writer_.write(channel->second, time_ns, time_ns, ros_messages::serialize(message));
  }

  void finish() { writer_.finish(); }
  std::size_t messages() const { return messages_; }

 private:
  /// That of all objects of a robot is one.
  static std::string topic_of(const std::string& topic) {
    const auto parsed = fleet_messages::parse_topic(topic);
    return parsed ? "/" + parsed->robot + "/" + std::string(name_of(parsed->kind)) : "/" + topic;
  }

  mcap::McapWriter writer_;
  std::map<std::string, std::uint16_t> channels_;
  std::size_t messages_ = 0;
};

}  // namespace

ExitCode run_fleet_record(const FleetRecordOptions& options) {
  if (exists(options.out) && !options.force) {
    throw CommandError(
        ExitCode::kUsage,
        options.out.string() + " exists\n  next: name another file, or add --force to replace it");
  }
  FleetWatch watch(options.as);
  FleetRecorder recorder(options.out);
  fleet_member::TeamPicture picture;
  double next_map_s = 0.0;
  const auto now_ns = [&] { return static_cast<std::uint64_t>(watch.now_s() * 1e9); };
  while (!console::interrupted() && (options.for_s <= 0.0 || watch.now_s() < options.for_s)) {
    for (const mqtt::Message& message : watch.listen()) {
      recorder.add(message, now_ns());
    }
    if (watch.now_s() >= next_map_s) {
      next_map_s = watch.now_s() + kMapPeriodS;
      if (picture.take_with_joins(watch.state())) {
        if (const auto snapshot = team_snapshot(picture, largest_map(picture))) {
          recorder.add_map(mapping::rasterize(*snapshot->grid), now_ns());
        }
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  recorder.finish();
  watch.require_own_account();
  console::print(fmt::format("{}: {} messages of {} robots",
                             options.out.string(),
                             recorder.messages(),
                             watch.state().robots.size()));
  if (recorder.messages() == 0) {
    throw CommandError(ExitCode::kUnfinished,
                       "nothing was said in the fleet '" + watch.fleet() +
                           "' meanwhile\n  next: echomap fleet status --as " + options.as.string());
  }
  return ExitCode::kOk;
}

}  // namespace echomap::apps

// SPDX-License-Identifier: MIT
#include "host/live_page/message_encoding.hpp"

#include <bit>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

namespace echomap::live_page {
namespace {

static_assert(std::endian::native == std::endian::little, "messages are little-endian");

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// A header, and what is appended to it.
class MessageWriter {
 public:
  MessageWriter(MessageKind kind, double time_s) : kind_(kind), time_s_(time_s) {
    bytes_.push_back(static_cast<char>(kind));
    bytes_.append(7, '\0');
    put(time_s);
  }

  template <class Number>
  void put(Number number) {
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    bytes_.append(raw, sizeof number);
  }
  void put_f32(double number) { put(static_cast<float>(number)); }
  void put(const geometry::Pose2& pose) {
    put_f32(pose.x_m());
    put_f32(pose.y_m());
    put_f32(pose.heading_rad());
  }
  void put_count(std::size_t count) {
    put(static_cast<std::uint32_t>(count));
    put(std::uint32_t{0});
  }
  void append(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }

  SharedMessage finish(std::uint64_t key = 0) {
    return std::make_shared<const Message>(Message{kind_, key, time_s_, std::move(bytes_)});
  }

 private:
  MessageKind kind_;
  double time_s_;
  std::string bytes_;
};

void put_covariance(MessageWriter& writer, const std::optional<Eigen::Matrix3d>& covariance) {
  if (!covariance) {
    for (int i = 0; i < 4; ++i) {
      writer.put(kUnknown);
    }
    return;
  }
  writer.put_f32((*covariance)(0, 0));
  writer.put_f32((*covariance)(0, 1));
  writer.put_f32((*covariance)(1, 1));
  writer.put_f32(std::sqrt((*covariance)(2, 2)));
}

std::uint64_t key_of(geometry::CellIndex tile) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(tile.y)) << 32U |
         static_cast<std::uint32_t>(tile.x);
}

}  // namespace

SharedMessage tile_message(double time_s,
                           geometry::CellIndex tile,
                           const mapping::GridTile& cells) {
  MessageWriter writer(MessageKind::kTile, time_s);
  writer.put(static_cast<std::int32_t>(tile.x));
  writer.put(static_cast<std::int32_t>(tile.y));
  writer.append(cells.cells.data(), cells.cells.size());
  return writer.finish(key_of(tile));
}

SharedMessage motion_message(double time_s, const MotionView& motion) {
  MessageWriter writer(MessageKind::kMotion, time_s);
  writer.put(motion.clock_ms);
  writer.put(motion.T_map_robot);
  put_covariance(writer, motion.covariance);
  writer.put(motion.T_odom_robot);
  if (motion.T_map_true_robot) {
    writer.put(*motion.T_map_true_robot);
  } else {
    for (int i = 0; i < 3; ++i) {
      writer.put(kUnknown);
    }
  }
  writer.put_f32(motion.ping.bearing_rad);
  writer.put(motion.ping.range_m ? static_cast<float>(*motion.ping.range_m) : kUnknown);
  writer.put(motion.ping.number);
  writer.put(static_cast<std::uint32_t>(motion.ping.result));
  return writer.finish();
}

SharedMessage particles_message(double time_s, const std::vector<WeightedPose>& particles) {
  MessageWriter writer(MessageKind::kParticles, time_s);
  writer.put_count(particles.size());
  for (const WeightedPose& particle : particles) {
    writer.put(particle.T_map_robot);
    writer.put_f32(particle.weight);
  }
  return writer.finish();
}

SharedMessage trail_message(double time_s, const std::vector<Eigen::Vector2d>& positions_m) {
  MessageWriter writer(MessageKind::kTrail, time_s);
  writer.put_count(positions_m.size());
  for (const Eigen::Vector2d& position_m : positions_m) {
    writer.put_f32(position_m.x());
    writer.put_f32(position_m.y());
  }
  return writer.finish();
}

SharedMessage json_message(MessageKind kind, double time_s, const nlohmann::ordered_json& json) {
  MessageWriter writer(kind, time_s);
  const std::string text =
      json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  writer.append(text.data(), text.size());
  return writer.finish();
}

SharedMessage new_map_message(double time_s) {
  return MessageWriter(MessageKind::kNewMap, time_s).finish();
}

}  // namespace echomap::live_page

// SPDX-License-Identifier: MIT
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/fleet_messages/conversions.hpp"
#include "host/fleet_messages/payload.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/support/random_fleet_message.hpp"

namespace {

using echomap::fuzz::Input;
using echomap::fuzz::require;
namespace fleet_messages = echomap::fleet_messages;
using namespace fleet_messages;

constexpr std::size_t kCheckBytes = 4;

/// What is accepted as an object converts to metres and back to the same numbers.
void convert(const MessageBody& body) {
  if (const auto* submap = std::get_if<SubmapMessage>(&body)) {
    require(to_message(to_submap(*submap), submap->map_number) == *submap,
            "a submap is the same in metres");
  } else if (const auto* graph = std::get_if<GraphMessage>(&body)) {
    const auto poses = to_poses(graph->T_map_submaps);
    require(to_graph_message(poses, to_covariance(graph->latest_covariance), 0)->T_map_submaps ==
                graph->T_map_submaps,
            "a graph is the same in metres");
  } else if (const auto* source = std::get_if<SourceMessage>(&body)) {
    require(to_source_batch(*source).readings.size() == source->readings.size(),
            "no reading is lost");
  } else if (const auto* pose = std::get_if<PoseMessage>(&body)) {
    require(to_pose_estimate(*pose).covariance.allFinite(), "a covariance is of numbers");
  }
}

void decode_whole(std::string_view payload) {
  const auto decoded = decode(payload);
  const auto* message = std::get_if<FleetMessage>(&decoded);
  if (message == nullptr) {
    return;
  }
  const auto again = encode(*message);
  require(again.has_value(), "what is accepted can be sent");
  const auto twice = decode(*again);
  require(std::get_if<FleetMessage>(&twice) != nullptr, "what is sent is accepted");
  require(std::get<FleetMessage>(twice) == *message, "a message is the same once more");
  convert(message->body);
}

}  // namespace

/// A message of every kind, without its check.
std::vector<Input> echomap::fuzz::seeds() {
  std::vector<Input> seeds;
  std::mt19937 random(1);
  for (std::size_t round = 0; round < 3; ++round) {
    for (std::size_t kind = 0; kind < std::variant_size_v<MessageBody>; ++kind) {
      const std::string payload =
          encode(echomap::tests::random_fleet_message(random, kind)).value();
      seeds.push_back(input_of(std::string_view(payload).substr(0, payload.size() - kCheckBytes)));
    }
  }
  return seeds;
}

/// One input is a payload, and once more one without its check, so that the decoders behind the
/// check have something to do.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string payload(data, data + size);
  decode_whole(payload);
  const ContentHash hash = content_hash(payload);
  payload.append(hash.bytes.begin(), hash.bytes.begin() + kCheckBytes);
  decode_whole(payload);
  return 0;
}

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "host/live_page/foxglove_topics.hpp"

namespace echomap::live_page {

/// What becomes of a frame whose client does not keep up.
enum class FoxgloveDelivery : std::uint8_t {
  kAlways,
  kNewest,  ///< A later frame with its key may take its place.
  kLossy,   ///< It may be left out.
};

/// A WebSocket frame to a client of the Foxglove protocol.
struct FoxgloveFrame {
  bool is_text = false;
  std::string bytes;
  FoxgloveDelivery delivery = FoxgloveDelivery::kAlways;
  std::uint64_t key = 0;
};

/// One client of the Foxglove WebSocket protocol, version 1: what it is sent, and what its frames
/// mean. Its two names on the line, `foxglove.websocket.v1` and `foxglove.sdk.v1`, differ in
/// nothing that this server sends or takes. Nothing throws; what is kept is bounded by the number
/// of channels, and so is the number of keys.
class FoxgloveSession {
 public:
  using Frames = std::vector<FoxgloveFrame>;

  /// In the order of preference.
  static constexpr std::array<std::string_view, 2> kSubProtocols{"foxglove.websocket.v1",
                                                                 "foxglove.sdk.v1"};

  /// `topics` outlive this.
  explicit FoxgloveSession(const FoxgloveTopics& topics) : topics_(topics) {}

  /// What goes out once the connection stands.
  Frames begin();
  /// What a frame of the client is answered with.
  Frames receive_text(std::string_view text);
  Frames receive_binary(std::string_view bytes);
  /// What is new since `begin` or the last call.
  Frames news();

  static constexpr std::size_t kMaxTextBytes = std::size_t{64} << 10;

 private:
  struct Subscription {
    std::uint32_t id = 0;
    bool is_picture = false;  ///< Each message makes the ones before it void.
    std::uint64_t last_sent = 0;
  };
  struct Complaints;

  void update_channels(Frames& frames);
  void subscribe(const nlohmann::json& wishes, Complaints& complaints, Frames& frames);
  void subscribe_one(const nlohmann::json& wish, Complaints& complaints, Frames& frames);
  void unsubscribe(const nlohmann::json& ids, Complaints& complaints);
  void add_message(const FoxgloveMessage& message, Frames& frames);
  void add_time(Frames& frames);

  const FoxgloveTopics& topics_;
  std::uint64_t generation_ = 0;
  std::uint64_t last_number_ = 0;  ///< Of the last message that `news` has seen.
  std::uint64_t now_ns_ = 0;       ///< The log time there.
  std::optional<std::uint64_t> told_ns_;
  std::map<std::uint32_t, SharedFoxgloveChannel> channels_;  ///< That the client knows.
  std::map<std::uint32_t, Subscription> subscriptions_;      ///< By channel.
};

}  // namespace echomap::live_page

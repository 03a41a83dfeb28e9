// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host/fleet_messages/payload.hpp"
#include "host/mqtt/message_bus.hpp"

namespace echomap::fleet {

/// Members of a fleet in lockstep, and when they repeat messages.
struct FleetRoundsParams {
  std::string fleet;
  std::string robot;
  /// The same for all robots of one run; clock messages of other runs are ignored.
  std::uint32_t boot_id = 1;
  std::vector<std::string> members;  ///< All robots of the fleet, this one included.
  /// The messages of the last two rounds are sent again when a round takes longer than this, in
  /// seconds of wall time.
  double repeat_after_s = 2.0;
};

/// Message bus for a fleet in lockstep: what robots publish in a round of simulated time is
/// delivered when all of them have ended the round, sorted by robot and counter. A run is therefore
/// a function of its seed, though its messages pass a real broker. Round 0 is over when all robots
/// have connected; nothing else may be published before.
class FleetRounds final : public mqtt::MessageBus {
 public:
  /// `bus` must outlive this. Throws std::invalid_argument for an invalid name, or where the robot
  /// is not a member.
  FleetRounds(mqtt::MessageBus& bus, const FleetRoundsParams& params);

  /// Publishes at least once, whatever `delivery` is: a round waits for all of its messages.
  bool publish(const std::string& topic,
               std::string_view payload,
               mqtt::Delivery delivery,
               bool retain) override;
  void subscribe(const std::string& filter) override { bus_.subscribe(filter); }
  /// Messages of the rounds that are over, and those that the broker had retained from before.
  std::vector<mqtt::Message> take() override;
  bool is_connected() const override { return bus_.is_connected(); }
  std::size_t connections() const override { return bus_.connections(); }

  /// Announces that this robot has published all of its round. With `leaves` it takes no part in
  /// later rounds.
  void end_round(bool leaves = false);
  /// Serves the bus. Returns true once the round that this robot ended last is over: take() then
  /// has its messages. `wall_s` is of a clock that never runs backwards.
  bool poll(double wall_s);

  /// Number of the current round, which this robot may have ended already.
  std::uint32_t round() const { return round_; }
  /// Robots that the round waits for.
  std::vector<std::string> waits_for() const;

 private:
  /// A message that may have to be sent again.
  struct Sent {
    std::string topic;
    std::string payload;
    bool is_retained = false;
  };
  /// Messages of one robot that were received and not delivered yet.
  struct Received {
    std::map<std::uint32_t, fleet_messages::ClockMessage> clocks;  ///< By round.
    std::map<std::uint32_t, mqtt::Message> messages;               ///< By counter.
    std::map<fleet_messages::ContentHash, mqtt::Message> objects;
    std::uint32_t released_counter = 0;
  };

  void serve();
  void sort_in(mqtt::Message message);
  void take_clock(const std::string& robot, const fleet_messages::FleetMessage& message);
  bool has_all_of(const std::string& robot) const;
  bool is_over() const;
  void release();
  void release(Received& received);
  void resend();
  void note_sent(const std::string& topic, std::string_view payload, bool retain);

  mqtt::MessageBus& bus_;
  FleetRoundsParams params_;
  std::set<std::string> living_;
  std::map<std::string, Received> received_;
  std::vector<mqtt::Message> ready_;
  std::uint32_t round_ = 0;
  bool has_ended_ = false;  ///< Whether this robot has ended the round.
  std::uint32_t last_counter_ = 0;
  std::vector<fleet_messages::ContentHash> objects_;  ///< Published in this round.
  std::vector<Sent> sent_;                            ///< In this round,
  std::vector<Sent> sent_before_;                     ///< and in the one before.
  std::size_t connections_ = 0;
  std::optional<double> repeated_s_;
};

}  // namespace echomap::fleet

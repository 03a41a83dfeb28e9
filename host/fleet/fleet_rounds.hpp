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

/// Who takes part in the rounds.
struct FleetRoundsParams {
  std::string fleet;
  std::string robot;
  /// The same for all robots of one run: clocks of other runs are of no account.
  std::uint32_t boot_id = 1;
  std::vector<std::string> members;  ///< All robots of the fleet, this one included.
  /// What was said in the last two rounds is said again where a round has not ended for so long, of
  /// wall time.
  double repeat_after_s = 2.0;
};

/// A bus for a fleet in lockstep: what robots say in a round of simulated time is heard when all of
/// them have ended the round, sorted by robot and counter. So a run is a function of its seed,
/// though messages go over a real broker. Round 0 is over when all have connected; nothing else may
/// be published before.
class FleetRounds final : public mqtt::MessageBus {
 public:
  /// The bus outlives it. Throws std::invalid_argument where a name is none, or where the robot is
  /// no member.
  FleetRounds(mqtt::MessageBus& bus, const FleetRoundsParams& params);

  /// Publishes at least once, whatever `delivery` says: a round waits for all of its messages.
  bool publish(const std::string& topic,
               std::string_view payload,
               mqtt::Delivery delivery,
               bool retain) override;
  void subscribe(const std::string& filter) override { bus_.subscribe(filter); }
  /// What was said in the rounds that are over, and what the broker had kept from before them.
  std::vector<mqtt::Message> take() override;
  bool is_connected() const override { return bus_.is_connected(); }
  std::size_t connections() const override { return bus_.connections(); }

  /// Says that this robot has said all of its round. `leaves`: it takes no part in the next ones.
  void end_round(bool leaves = false);
  /// Serves the bus. True when the round that this robot has ended last is over: then take() has
  /// its messages. `wall_s` is of a clock that does not go back.
  bool poll(double wall_s);

  /// The round that goes on, or that was ended last and is not over.
  std::uint32_t round() const { return round_; }
  /// For whom the round waits.
  std::vector<std::string> waits_for() const;

 private:
  /// A message that may be said again.
  struct Said {
    std::string topic;
    std::string payload;
    bool is_retained = false;
  };
  /// What was heard of one robot and is not released.
  struct Heard {
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
  void release(Heard& heard);
  void say_again();
  void note_said(const std::string& topic, std::string_view payload, bool retain);

  mqtt::MessageBus& bus_;
  FleetRoundsParams params_;
  std::set<std::string> living_;
  std::map<std::string, Heard> heard_;
  std::vector<mqtt::Message> ready_;
  std::uint32_t round_ = 0;
  bool has_ended_ = false;  ///< This robot's part of the round.
  std::uint32_t last_counter_ = 0;
  std::vector<fleet_messages::ContentHash> objects_;  ///< Published in this round.
  std::vector<Said> said_;                            ///< In this round,
  std::vector<Said> said_before_;                     ///< and in the one before.
  std::size_t connections_ = 0;
  std::optional<double> repeated_s_;
};

}  // namespace echomap::fleet

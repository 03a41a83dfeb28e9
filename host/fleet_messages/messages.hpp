// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/fleet_messages/content_hash.hpp"
#include "host/fleet_messages/table_rows.hpp"
#include "host/fleet_messages/topic.hpp"

// Messages between the robots of a fleet, in whole numbers: lengths in millimetres, times in
// milliseconds of the author's clock, angles in turns / 65536 (0.096 mrad). conversions.hpp
// converts them to metres, seconds and radians. docs/fleet_protocol.md has the same lists.
namespace echomap::fleet_messages {

/// Largest time, some 8900 years.
inline constexpr std::uint64_t kMaxStampMs = (std::uint64_t{1} << 48U) - 1;

/// Largest distance of a submap's poses from its first reading, and of a map's submaps from its
/// first stop. Grids cover them: a map that spans the earth would exhaust the memory of all robots.
inline constexpr std::int64_t kMaxSubmapReachMm = 30'000;
inline constexpr std::int64_t kMaxMapReachMm = 100'000;
/// Largest distance in a map of several robots.
inline constexpr std::int64_t kMaxTeamReachMm = 2 * kMaxMapReachMm;

/// Whether a pose lies within `reach_mm` of another one, in x and in y.
constexpr bool is_within(const PoseRow& pose, const PoseRow& middle, std::int64_t reach_mm) {
  const std::int64_t x_mm = std::int64_t{pose.x_mm} - middle.x_mm;
  const std::int64_t y_mm = std::int64_t{pose.y_mm} - middle.y_mm;
  return std::max({x_mm, -x_mm, y_mm, -y_mm}) <= reach_mm;
}

/// Whether a robot takes part.
enum class PresenceState : std::uint8_t {
  kHere,
  kLeft,  ///< It has announced that it leaves.
  kGone,  ///< Its last will: the broker has lost its connection.
};

/// Heartbeat of a robot: whether it takes part, its traits, and which data it has. Sent every few
/// seconds.
struct PresenceMessage {
  static constexpr TopicKind kKind = TopicKind::kPresence;
  std::uint8_t state = 0;        ///< A PresenceState.
  std::uint16_t map_number = 0;  ///< Map that it is building now.
  std::uint16_t body_radius_mm = 0;
  std::uint16_t beam_half_angle = 2367;  ///< 13 degrees.
  std::uint32_t own_objects = 0;         ///< Number of objects in its manifest.
  ContentHash latest_set;           ///< Of the payloads of its latest graphs, claims and alignment.
  std::uint32_t known_objects = 0;  ///< Number of objects that it has, of any robot,
  ContentHash known_set;            ///< and the hash of their set.
  bool operator==(const PresenceMessage&) const = default;

  /// Whether the traits are plausible: a hull of up to 5 m, a beam of up to 45 degrees to each
  /// side.
  bool is_consistent() const {
    return body_radius_mm <= 5000 && beam_half_angle > 0 && beam_half_angle <= 65536 / 8;
  }

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("state", self.state, std::uint64_t{2});
    visit("map_number", self.map_number);
    visit("body_radius_mm", self.body_radius_mm);
    visit("beam_half_angle", self.beam_half_angle);
    visit("own_objects", self.own_objects);
    visit("latest_set", self.latest_set);
    visit("known_objects", self.known_objects);
    visit("known_set", self.known_set);
  }
};

/// Pose of a robot in its own map.
struct PoseMessage {
  static constexpr TopicKind kKind = TopicKind::kPose;
  std::uint64_t stamp_ms = 0;
  std::uint16_t map_number = 0;
  PoseRow T_map_robot;
  CovariancePart covariance;
  bool operator==(const PoseMessage&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("stamp_ms", self.stamp_ms, kMaxStampMs);
    visit("map_number", self.map_number);
    PoseRow::fields(self.T_map_robot, visit);
    visit("covariance", self.covariance);
  }
};

/// An object: the readings of one stop and of the path to it (team_map::Submap). Never changes.
struct SubmapMessage {
  static constexpr TopicKind kKind = TopicKind::kSubmap;
  std::uint16_t map_number = 0;
  std::uint32_t index = 0;
  std::uint64_t begin_ms = 0;
  std::uint64_t end_ms = 0;
  std::vector<ReadingRow> readings;
  std::vector<PoseRow> T_odom_way;
  std::vector<ContactRow> contacts;
  bool operator==(const SubmapMessage&) const = default;

  /// Whether the submap has readings, its times are in order, and all of it lies near its first
  /// reading.
  bool is_consistent() const {
    const auto is_near = [this](const PoseRow& T_odom_robot) {
      return is_within(T_odom_robot, readings.front().T_odom_robot, kMaxSubmapReachMm);
    };
    return !readings.empty() && begin_ms <= end_ms &&
           std::ranges::all_of(readings, is_near, &ReadingRow::T_odom_robot) &&
           std::ranges::all_of(T_odom_way, is_near) &&
           std::ranges::all_of(contacts, is_near, &ContactRow::T_odom_robot);
  }

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("map_number", self.map_number);
    visit("index", self.index);
    visit("begin_ms", self.begin_ms, kMaxStampMs);
    visit("end_ms", self.end_ms, kMaxStampMs);
    visit("readings", self.readings);
    visit("T_odom_way", self.T_odom_way);
    visit("contacts", self.contacts);
  }
};

/// Pose graph of a robot: poses of its submaps in its map, as its SLAM has them now.
struct GraphMessage {
  static constexpr TopicKind kKind = TopicKind::kGraph;
  std::uint16_t map_number = 0;
  CovariancePart latest_covariance;    ///< Of the last pose, given the first.
  std::vector<PoseRow> T_map_submaps;  ///< By index of the submap.
  bool operator==(const GraphMessage&) const = default;

  bool is_consistent() const {
    return std::ranges::all_of(T_map_submaps, [](const PoseRow& T_map_submap) {
      return is_within(T_map_submap, {}, kMaxMapReachMm);
    });
  }

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("map_number", self.map_number);
    visit("latest_covariance", self.latest_covariance);
    visit("T_map_submaps", self.T_map_submaps);
  }
};

/// One page of the list of a robot's objects: their names, in the order in which they were made.
struct ManifestMessage {
  static constexpr TopicKind kKind = TopicKind::kManifest;
  /// Full pages never change, so that a new object costs one page, not the whole list.
  static constexpr std::size_t kObjectsPerPage = 32;
  std::uint16_t page = 0;
  std::vector<ContentHash> objects;
  bool operator==(const ManifestMessage&) const = default;

  bool is_consistent() const { return objects.size() <= kObjectsPerPage; }

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("page", self.page);
    visit("objects", self.objects);
  }
};

/// Name of another robot.
struct RobotNamePart {
  static constexpr bool kIsPart = true;
  std::string robot;
  bool operator==(const RobotNamePart&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("robot", self.robot);
  }
};

/// Viewpoints that a robot claims; none where it gives its claims back.
struct ClaimMessage {
  static constexpr TopicKind kKind = TopicKind::kClaim;
  std::uint16_t map_number = 0;
  std::vector<ClaimRow> claims;
  std::vector<RobotNamePart> waits_for{};  ///< The robot that stands in its way; one at most.
  bool operator==(const ClaimMessage&) const = default;

  bool is_consistent() const { return waits_for.size() <= 1; }

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("map_number", self.map_number);
    visit("claims", self.claims);
    visit("waits_for", self.waits_for);
  }
};

/// An object: readings of a scalar sensor. Never changes.
struct SourceMessage {
  static constexpr TopicKind kKind = TopicKind::kSource;
  std::uint16_t map_number = 0;
  std::uint32_t submap_index = 0;  ///< Submap in whose odometry frame the poses are.
  std::uint64_t begin_ms = 0;
  std::vector<SourceRow> readings;
  bool operator==(const SourceMessage&) const = default;

  bool is_consistent() const { return !readings.empty(); }

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("map_number", self.map_number);
    visit("submap_index", self.submap_index);
    visit("begin_ms", self.begin_ms, kMaxStampMs);
    visit("readings", self.readings);
  }
};

/// End of a robot's part of a round of a fleet in lockstep (fleet::FleetRounds).
struct ClockMessage {
  static constexpr TopicKind kKind = TopicKind::kClock;
  std::uint32_t round = 0;
  std::uint32_t last_counter = 0;    ///< Counter of its latest message except clocks and objects.
  std::uint8_t leaves = 0;           ///< 1: it takes no part in later rounds.
  std::vector<ContentHash> objects;  ///< Published in this round.
  bool operator==(const ClockMessage&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("round", self.round);
    visit("last_counter", self.last_counter);
    visit("leaves", self.leaves, std::uint64_t{1});
    visit("objects", self.objects);
  }
};

/// Poses of joined maps in one frame, published by the robot of them whose name comes first: the
/// graph that all of them use.
struct AlignmentMessage {
  static constexpr TopicKind kKind = TopicKind::kAlignment;
  std::vector<AlignedMapPart> maps;
  bool operator==(const AlignmentMessage&) const = default;

  bool is_consistent() const {
    const auto is_near = [](const PoseRow& pose) { return is_within(pose, {}, kMaxTeamReachMm); };
    return std::ranges::all_of(maps, [&](const AlignedMapPart& map) {
      return is_near(map.T_component_map) && std::ranges::all_of(map.T_component_submaps, is_near);
    });
  }

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("maps", self.maps);
  }
};

/// Request for data of another robot that the author misses.
struct AskMessage {
  static constexpr TopicKind kKind = TopicKind::kAsk;
  std::string robot;
  std::uint8_t everything_else = 0;  ///< 1: its manifest, graphs, claims and alignment, too.
  std::vector<ContentHash> objects;
  bool operator==(const AskMessage&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("robot", self.robot);
    visit("everything_else", self.everything_else, std::uint64_t{1});
    visit("objects", self.objects);
  }
};

/// What a robot that searches a source has found, and what it is about to read.
struct SearchMessage {
  static constexpr TopicKind kKind = TopicKind::kSearch;
  std::uint16_t map_number = 0;
  std::uint8_t verdict = 0;             ///< A source_search::SourceVerdict.
  std::uint16_t probability_milli = 0;  ///< Of the verdict.
  std::int32_t x_mm = 0;                ///< Position of the source; 0 where it is not found.
  std::int32_t y_mm = 0;
  std::uint32_t strength_milli = 0;  ///< Thousandths of a pulse a second at 1 m, or of the level.
  std::vector<DwellRow> plan;
  bool operator==(const SearchMessage&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("map_number", self.map_number);
    visit("verdict", self.verdict, std::uint64_t{2});
    visit("probability_milli", self.probability_milli, std::uint64_t{1000});
    visit("x_mm", self.x_mm);
    visit("y_mm", self.y_mm);
    visit("strength_milli", self.strength_milli);
    visit("plan", self.plan);
  }
};

/// Any message. The index of a type, plus one, is its kind in a payload.
using MessageBody = std::variant<PresenceMessage,
                                 PoseMessage,
                                 SubmapMessage,
                                 GraphMessage,
                                 ManifestMessage,
                                 ClaimMessage,
                                 SourceMessage,
                                 ClockMessage,
                                 AlignmentMessage,
                                 AskMessage,
                                 SearchMessage>;

/// Whether a kind is that of objects, which are named by their hash, without boot id and counter.
constexpr bool is_object(TopicKind kind) {
  return kind == TopicKind::kSubmap || kind == TopicKind::kSource;
}

}  // namespace echomap::fleet_messages

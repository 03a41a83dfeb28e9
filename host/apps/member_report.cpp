// SPDX-License-Identifier: MIT
#include "host/apps/member_report.hpp"

#include <optional>

#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"

namespace echomap::apps {
namespace {

using fleet_member::LoggedJoin;
using nlohmann::ordered_json;

ordered_json join_json(const LoggedJoin& join) {
  return {{"own_map", join.own_map},
          {"map", join.peer_map},
          {"from_s", join.from_s},
          {"until_s", join.until_s ? ordered_json(*join.until_s) : ordered_json()},
          {"x_m", join.T_own_peer.x_m()},
          {"y_m", join.T_own_peer.y_m()},
          {"heading_rad", join.T_own_peer.heading_rad()}};
}

LoggedJoin logged_join(const ordered_json& json) {
  LoggedJoin join{json.at("own_map"), json.at("map"), json.at("from_s"), std::nullopt, {}};
  if (!json.at("until_s").is_null()) {
    join.until_s = json.at("until_s").get<double>();
  }
  join.T_own_peer = {json.at("x_m").get<double>(),
                     json.at("y_m").get<double>(),
                     json.at("heading_rad").get<double>()};
  return join;
}

ordered_json encounters_json(const MemberEncounters& encounters) {
  return {{"waits", encounters.counts.waits},
          {"bumps", encounters.counts.bumps},
          {"deadlocks", encounters.counts.deadlocks},
          {"made_way", encounters.counts.made_way},
          {"without_place", encounters.counts.without_place},
          {"ended_in_deadlock", encounters.ended_in_deadlock}};
}

MemberEncounters told_encounters(const ordered_json& json) {
  return {{.waits = json.at("waits"),
           .bumps = json.at("bumps"),
           .deadlocks = json.at("deadlocks"),
           .made_way = json.at("made_way"),
           .without_place = json.at("without_place")},
          json.at("ended_in_deadlock")};
}

}  // namespace

void MemberEncounters::add(const team_exploration::Encounters& of_one, bool is_in_deadlock) {
  counts.waits += of_one.waits;
  counts.bumps += of_one.bumps;
  counts.deadlocks += of_one.deadlocks;
  counts.made_way += of_one.made_way;
  counts.without_place += of_one.without_place;
  ended_in_deadlock = is_in_deadlock;
}

ordered_json team_report(const fleet_member::JoinLog& joins, const MemberEncounters& encounters) {
  auto list = ordered_json::array();
  for (const LoggedJoin& join : joins.joins()) {
    list.push_back(join_json(join));
  }
  return {{"joins", list}, {"encounters", encounters_json(encounters)}};
}

MemberReport read_member_report(const std::string& robot, const std::filesystem::path& run) {
  const auto file = run / "summary.json";
  try {
    const auto json = ordered_json::parse(files::read_text_file(file));
    MemberReport member;
    member.robot = robot;
    member.outcome = json.at("outcome");
    member.sim_seconds = json.at("sim_seconds");
    member.stops = json.at("stops");
    const auto& team = json.at("team");
    for (const auto& join : team.at("joins")) {
      member.joins.push_back(logged_join(join));
    }
    member.encounters = told_encounters(team.at("encounters"));
    return member;
  } catch (const ordered_json::exception& error) {
    throw files::FileError(file.string() + ": " + error.what());
  }
}

ordered_json to_json(const MemberReport& member) {
  if (member.outcome.empty()) {
    return {{"outcome", nullptr},
            {"sim_seconds", nullptr},
            {"stops", nullptr},
            {"encounters", nullptr}};
  }
  return {{"outcome", member.outcome},
          {"sim_seconds", member.sim_seconds},
          {"stops", member.stops},
          {"encounters", encounters_json(member.encounters)}};
}

}  // namespace echomap::apps

// SPDX-License-Identifier: MIT
#include "host/apps/kidnap_report.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/evaluation/own_map_pose.hpp"
#include "host/geometry/angle.hpp"
#include "host/tracking/pose_report.hpp"

namespace echomap::apps {
namespace {

using evaluation::PlaceError;
using nlohmann::ordered_json;

constexpr const char* kLocalized = "localized";
constexpr const char* kAmbiguous = "ambiguous";
constexpr double kFoundM = 0.15;
constexpr double kFoundRad = geometry::radians(10.0);

std::string how_it_ended(const DemoKidnap& kidnap) {
  if (kidnap.stops.empty()) {
    return "not localized";
  }
  const KidnapStop& last = kidnap.stops.back();
  if (last.status == localization::LocalizationStatus::kLocalized) {
    return kLocalized;
  }
  return last.places >= 2 ? kAmbiguous : "not localized";
}

/// The robot is put somewhere else at once: the greatest step of its true way since it explored.
double carried_m(const DemoKidnap& kidnap, const std::vector<evaluation::TruePose>& truth) {
  double greatest_m = 0.0;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    if (truth[i].stamp > kidnap.explored.back().stamp) {
      const Eigen::Vector2d step_m =
          truth[i].T_world_robot.position_m() - truth[i - 1].T_world_robot.position_m();
      greatest_m = std::max(greatest_m, step_m.norm());
    }
  }
  return greatest_m;
}

void put_error(const std::optional<PlaceError>& error, ordered_json& json) {
  json["error_m"] = error ? ordered_json(error->error_m) : ordered_json();
  json["heading_error_rad"] = error ? ordered_json(error->heading_error_rad) : ordered_json();
}

ordered_json json_of(const KidnapStop& stop, const std::optional<PlaceError>& error) {
  ordered_json json{{"status", tracking::name_of(stop.status)},
                    {"lost_probability", stop.lost_probability}};
  put_error(error, json);
  json["places"] = stop.places;
  return json;
}

}  // namespace

ordered_json kidnap_report(const DemoKidnap& kidnap,
                           const std::vector<evaluation::TruePose>& truth) {
  auto told = ordered_json::array();
  std::optional<PlaceError> last;
  for (const KidnapStop& stop : kidnap.stops) {
    last = stop.told ? evaluation::own_map_error(kidnap.explored, truth, *stop.told) : std::nullopt;
    told.push_back(json_of(stop, last));
  }
  const std::string ended = how_it_ended(kidnap);
  if (ended != kLocalized) {
    last.reset();
  }
  const bool is_found = last && last->error_m <= kFoundM && last->heading_error_rad <= kFoundRad;
  ordered_json json{
      {"noticed", kidnap.is_noticed}, {"found", is_found}, {"stops", kidnap.stops.size()}};
  put_error(last, json);
  json["carried_m"] =
      kidnap.stops.empty() ? ordered_json() : ordered_json(carried_m(kidnap, truth));
  json["ended"] = ended;
  json["gave_up"] =
      kidnap.gave_up ? ordered_json(exploration::name_of(*kidnap.gave_up)) : ordered_json();
  json["stops_told"] = std::move(told);
  return json;
}

std::string kidnap_line(const ordered_json& report) {
  const auto stops = report.at("stops").get<std::size_t>();
  if (stops == 0) {
    return "carried off: the run ended before it could look around";
  }
  std::string after =
      fmt::format("carried off: after {} {} it ", stops, stops == 1 ? "stop" : "stops");
  const bool gave_up = !report.at("gave_up").is_null();
  if (gave_up) {
    after += fmt::format("drove no further ({}) and ", report.at("gave_up").get<std::string>());
  }
  if (report.at("ended") == kAmbiguous) {
    return after + fmt::format("cannot tell {} places from each other{}",
                               report.at("stops_told").back().at("places").get<std::size_t>(),
                               gave_up ? "" : ", which is right in a room where they look alike");
  }
  if (report.at("error_m").is_null()) {
    return after + "still does not know where it is";
  }
  const PlaceError error{report.at("error_m"), report.at("heading_error_rad")};
  return after + fmt::format("{}, {:.0f} cm off",
                             error.is_right() ? "was relocalized" : "claimed a wrong place",
                             100.0 * error.error_m);
}

}  // namespace echomap::apps

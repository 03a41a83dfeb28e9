// SPDX-License-Identifier: MIT
#include "host/exports/summary_json.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"

namespace echomap::exports {
namespace {

template <class T>
nlohmann::ordered_json or_null(const std::optional<T>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

nlohmann::ordered_json to_json(const LinkSummary& link) {
  return {
      {"frames_received", link.frames_received},
      {"frames_bad", link.frames_bad},
      {"frames_lost", link.frames_lost},
      {"frames_sent", link.frames_sent},
      {"commands_resent", link.commands_resent},
      {"credit_released_bytes", link.credit_released_bytes},
      {"round_trip_us", or_null(link.round_trip_us)},
      {"resets", link.resets},
      {"outages", link.outages},
      {"outage_seconds", link.outage_seconds},
      {"reconnects", link.reconnects},
      {"robot_frames_bad", link.robot_frames_bad},
      {"robot_frames_lost", link.robot_frames_lost},
      {"robot_receive_overruns", link.robot_receive_overruns},
      {"robot_telemetry_dropped", link.robot_telemetry_dropped},
      {"robot_encoder_errors", or_null(link.robot_encoder_errors)},
      {"robot_left_encoder_errors", or_null(link.robot_left_encoder_errors)},
      {"robot_right_encoder_errors", or_null(link.robot_right_encoder_errors)},
      {"robot_stack_free_bytes", or_null(link.robot_stack_free_bytes)},
      {"robot_rate_step", link.robot_rate_step},
  };
}

nlohmann::ordered_json to_json(const CoverageSummary& coverage) {
  nlohmann::ordered_json json{{"share", coverage.share},
                              {"seen_m2", coverage.seen_m2},
                              {"unseen_m2", coverage.unseen_m2},
                              {"places", nlohmann::ordered_json::array()},
                              {"gaps", nlohmann::ordered_json::array()},
                              {"possible_doors", nlohmann::ordered_json::array()}};
  for (const auto& [x_m, y_m, area_m2] : coverage.places) {
    json["places"].push_back({{"x_m", x_m}, {"y_m", y_m}, {"area_m2", area_m2}});
  }
  for (const auto& [x_m, y_m, width_m, behind_m2] : coverage.gaps) {
    json["gaps"].push_back(
        {{"x_m", x_m}, {"y_m", y_m}, {"width_m", width_m}, {"behind_m2", behind_m2}});
  }
  for (const auto& [x_m, y_m, width_m] : coverage.possible_doors) {
    json["possible_doors"].push_back({{"x_m", x_m}, {"y_m", y_m}, {"width_m", width_m}});
  }
  return json;
}

}  // namespace

nlohmann::ordered_json to_json(const std::optional<FaultSummary>& fault) {
  if (!fault) {
    return nullptr;
  }
  return {{"name", fault->name},
          {"value", fault->value},
          {"log_odds",
           std::isfinite(fault->log_odds) ? nlohmann::ordered_json(fault->log_odds)
                                          : nlohmann::ordered_json()},
          {"stops", fault->stops}};
}

std::string to_json_text(const RunSummary& summary) {
  const nlohmann::ordered_json json{
      {"echomap_version", summary.echomap_version},
      {"strategy", summary.strategy},
      {"outcome", summary.outcome},
      {"finished", summary.finished},
      {"why", summary.why},
      {"next", summary.next},
      {"coverage", summary.coverage ? to_json(*summary.coverage) : nlohmann::ordered_json()},
      {"expected_wall_rmse_m", or_null(summary.expected_wall_rmse_m)},
      {"wall_rmse_p90_m", or_null(summary.wall_rmse_p90_m)},
      {"robot_fault", to_json(summary.robot_fault)},
      {"robot", summary.robot},
      {"slam", summary.slam},
      {"world", summary.world},
      {"firmware", summary.firmware},
      {"emulator", summary.emulator},
      {"seed", summary.seed},
      {"sim_seconds", summary.sim_seconds},
      {"wall_seconds", summary.wall_seconds},
      {"clock_rate_error_ppm", or_null(summary.clock_rate_error_ppm)},
      {"clock_uncertainty_us", or_null(summary.clock_uncertainty_us)},
      {"link", to_json(summary.link)},
      {"stops", summary.stops},
      {"resumed_stops", or_null(summary.resumed_stops)},
      {"previous_maps", summary.previous_maps},
      {"maps_joined", summary.maps_joined},
      {"poses", summary.poses},
      {"points", summary.points},
      {"outline_by_strategy", summary.outline_by_strategy},
      {"phases", or_null(summary.phases)},
      {"phases_reached", or_null(summary.phases_reached)},
      {"pose_stddev_m", or_null(summary.pose_stddev_m)},
      {"pose_stddev_deg", or_null(summary.pose_stddev_deg)},
      {"travelled_m", summary.travelled_m},
      {"free_area_m2", summary.free_area_m2},
  };
  // Names may come from a device: bytes that are no UTF-8 are replaced, not thrown at.
  constexpr int kIndent = 2;
  using Json = nlohmann::ordered_json;
  return json.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_summary_json(const std::filesystem::path& path, const RunSummary& summary) {
  files::write_text_file(path, to_json_text(summary));
}

}  // namespace echomap::exports

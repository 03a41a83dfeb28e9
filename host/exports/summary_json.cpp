// SPDX-License-Identifier: MIT
#include "host/exports/summary_json.hpp"

#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"

namespace echomap::exports {
namespace {

nlohmann::ordered_json or_null(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

}  // namespace

std::string to_json_text(const RunSummary& summary) {
  const nlohmann::ordered_json json{
      {"echomap_version", summary.echomap_version},
      {"strategy", summary.strategy},
      {"outcome", summary.outcome},
      {"robot", summary.robot},
      {"world", summary.world},
      {"firmware", summary.firmware},
      {"emulator", summary.emulator},
      {"seed", summary.seed},
      {"sim_seconds", summary.sim_seconds},
      {"wall_seconds", summary.wall_seconds},
      {"clock_rate_error_ppm", or_null(summary.clock_rate_error_ppm)},
      {"clock_uncertainty_us", or_null(summary.clock_uncertainty_us)},
      {"stops", summary.stops},
      {"poses", summary.poses},
      {"points", summary.points},
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

// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/map_file.hpp"
#include "host/apps/report.hpp"
#include "host/console/print.hpp"
#include "host/evaluation/difference_picture.hpp"
#include "host/exports/pgm_yaml.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::apps {
namespace {

const char* name_of(evaluation::ChangeKind kind) {
  return kind == evaluation::ChangeKind::kAppeared ? "appeared" : "vanished";
}

nlohmann::ordered_json json_of(const evaluation::ChangedRegion& region) {
  return {{"change", name_of(region.kind)},
          {"x_m", region.center_m.x()},
          {"y_m", region.center_m.y()},
          {"width_m", region.size_m.x()},
          {"height_m", region.size_m.y()},
          {"area_m2", region.area_m2},
          {"confidence", region.confidence}};
}

nlohmann::ordered_json json_of(const evaluation::MapDifference& difference) {
  const auto& T_a_b = difference.alignment.T_a_b;
  nlohmann::ordered_json json{
      {"agreement", difference.alignment.agreement},
      {"T_a_b", {{"x_m", T_a_b.x_m()}, {"y_m", T_a_b.y_m()}, {"heading_rad", T_a_b.heading_rad()}}},
      {"regions", nlohmann::ordered_json::array()}};
  for (const auto& region : difference.regions) {
    json["regions"].push_back(json_of(region));
  }
  return json;
}

void print(const evaluation::MapDifference& difference) {
  const auto& T_a_b = difference.alignment.T_a_b;
  console::print(
      fmt::format("  aligned by {:.2f} m, {:.2f} m, {:.1f} degrees; {:.0f} % of the walls agree",
                  T_a_b.x_m(),
                  T_a_b.y_m(),
                  geometry::degrees(T_a_b.heading_rad()),
                  100.0 * difference.alignment.agreement));
  for (const auto& region : difference.regions) {
    console::print(fmt::format("  {} at {:.2f}, {:.2f} m: {:.2f} x {:.2f} m, confidence {:.2f}",
                               name_of(region.kind),
                               region.center_m.x(),
                               region.center_m.y(),
                               region.size_m.x(),
                               region.size_m.y(),
                               region.confidence));
  }
  if (difference.regions.empty()) {
    console::print("  nothing has changed");
  }
}

}  // namespace

ExitCode run_diff(const DiffOptions& options) {
  const auto before = exports::read_pgm_yaml(map_file_of(options.before));
  const auto after = exports::read_pgm_yaml(map_file_of(options.after));
  const auto difference = evaluation::find_difference(before, after);
  if (!difference) {
    throw CommandError(ExitCode::kRuntimeError,
                       "the maps of " + options.before.string() + " and " + options.after.string() +
                           " have nothing in common\n  next: compare two runs of one room that "
                           "start within 1 m and 30 degrees of each other");
  }
  print(*difference);
  if (!options.picture.empty()) {
    evaluation::write_difference_picture(options.picture, before, after, *difference);
  }
  write_report(options.json, json_of(*difference));
  return ExitCode::kOk;
}

}  // namespace echomap::apps

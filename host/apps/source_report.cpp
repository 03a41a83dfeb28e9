// SPDX-License-Identifier: MIT
#include "host/apps/source_report.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Core>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "host/source_search/source_layer.hpp"

namespace echomap::apps {
namespace {

using source_search::SourceBelief;
using Report = nlohmann::ordered_json;

Eigen::Vector2d best_m(const Report& report) {
  return {report.at("best_m").at(0).get<double>(), report.at("best_m").at(1).get<double>()};
}

std::string place_of(const Report& report) {
  const Eigen::Vector2d at_m = best_m(report);
  return fmt::format("({:.2f}, {:.2f})", at_m.x(), at_m.y());
}

std::string strength_of(const Report& report) {
  const Report& strength = report.at("strength");
  return strength.is_null() ? std::string("unknown strength")
                            : fmt::format("{:.1f} pulses/s at 1 m (known to a factor of {:.2f})",
                                          strength.at("median").get<double>(),
                                          std::exp(strength.at("log_stddev").get<double>()));
}

std::string text_of_source(const Report& report) {
  return fmt::format(
      "a source of {} is at {} of the map, within {:.2f} m with 95 %, within {:.2f} m with {:.0f} "
      "%",
      strength_of(report),
      place_of(report),
      report.at("radius_95_m").get<double>(),
      report.at("found_radius_m").get<double>(),
      100.0 * report.at("within_probability").get<double>());
}

std::string text_of_none(const Report& report) {
  return fmt::format(
      "there is no source of {:.1f} pulses/s at 1 m or more where the robot can be near it, with "
      "{:.0f} %",
      report.at("min_strength").get<double>(),
      100.0 * report.at("none_probability").get<double>());
}

/// Of what another robot of a fleet has told.
std::string text_of_told(const Report& report) {
  const std::string robot = report.at("told_by");
  if (report.at("verdict") == "none") {
    return fmt::format("{} has shown that there is no source that counts, with {:.0f} %",
                       robot,
                       100.0 * report.at("none_probability").get<double>());
  }
  return fmt::format("{} has found a source of {:.1f} pulses/s at 1 m, with {:.0f} %, {}",
                     robot,
                     report.at("strength").at("median").get<double>(),
                     100.0 * report.at("within_probability").get<double>(),
                     report.at("best_m").is_null()
                         ? "on its own map, which is not joined to this one"
                         : "at " + place_of(report) + " of this map");
}

std::string text_of_unsure(const Report& report) {
  if (!report.contains("best_m")) {
    return "nothing was read on any map";
  }
  return fmt::format(
      "no source with {:.0f} %, one on floor that was not seen with {:.0f} %; else most probably "
      "at {} of the map",
      100.0 * report.at("none_probability").get<double>(),
      100.0 * report.at("unseen_probability").get<double>(),
      place_of(report));
}

}  // namespace

Report source_report(const SourceBelief* belief) {
  if (belief == nullptr) {
    return {{"verdict", "unsure"}};
  }
  Report report = Report::parse(source_search::source_json(belief->estimate(), belief->params()));
  if (belief->estimate().verdict == source_search::SourceVerdict::kUndecided) {
    report["verdict"] = "unsure";
  }
  report["readings"] = belief->grid().readings().size();
  return report;
}

Report told_report(const fleet_member::TeamFinding& told) {
  const fleet_messages::SearchReport& said = told.report;
  Report report{{"verdict", source_search::name_of(said.verdict)}, {"told_by", told.robot}};
  if (said.verdict == source_search::SourceVerdict::kFound) {
    report["best_m"] = told.at_m ? Report{told.at_m->x(), told.at_m->y()} : Report();
    report["within_probability"] = said.probability;
    report["strength"] = {{"median", said.strength}, {"log_stddev", nullptr}};
  } else {
    report["none_probability"] = said.probability;
  }
  return report;
}

void add_source_truth(const std::filesystem::path& truth_json, Report& report) {
  if (!std::filesystem::exists(truth_json)) {
    return;
  }
  const auto truth = nlohmann::json::parse(files::read_text_file(truth_json));
  Report sources = Report::array();
  std::optional<double> error_m;
  for (const auto& source : truth.at("sources")) {
    if (source.at("kind") != "radiation") {
      continue;
    }
    const Eigen::Vector2d at_m(source.at("map_x_m").get<double>(),
                               source.at("map_y_m").get<double>());
    sources.push_back({{"x_m", at_m.x()}, {"y_m", at_m.y()}, {"strength", source.at("strength")}});
    if (report.contains("best_m")) {
      const double distance_m = (best_m(report) - at_m).norm();
      error_m = std::min(error_m.value_or(distance_m), distance_m);
    }
  }
  Report& scored = report["truth"];
  scored = {
      {"sources", sources}, {"error_m", nullptr}, {"right", nullptr}, {"is_in_radius_95", nullptr}};
  if (report.at("verdict") == "none") {
    scored["right"] = sources.empty();
  } else if (report.at("verdict") == "found") {
    scored["right"] = error_m && *error_m <= report.at("found_radius_m").get<double>();
    if (report.contains("radius_95_m")) {
      scored["is_in_radius_95"] = error_m && *error_m <= report.at("radius_95_m").get<double>();
    }
    if (error_m) {
      scored["error_m"] = std::round(*error_m * 1e4) / 1e4;
    }
  }
}

RunEnding ending_of_search(RunEnding drive, const Report& report, const NextCommands& next) {
  if (drive.code != console::ExitCode::kOk && drive.code != console::ExitCode::kUnfinished) {
    return drive;
  }
  const std::string verdict = report.at("verdict");
  if (report.contains("told_by")) {
    return {verdict, console::ExitCode::kOk, text_of_told(report), next.use};
  }
  if (verdict == "found") {
    return {verdict, console::ExitCode::kOk, text_of_source(report), next.use};
  }
  if (verdict == "none") {
    return {verdict, console::ExitCode::kOk, text_of_none(report), next.use};
  }
  const std::string why =
      drive.outcome == "stop-limit" ? "its time is over" : "it ended as " + drive.outcome;
  return {drive.outcome,
          console::ExitCode::kUnfinished,
          "it is unsure of a source: " + why + "; " + text_of_unsure(report),
          next.go_on};
}

void write_source_density(const std::filesystem::path& path, const SourceBelief& belief) {
  constexpr double kResolutionM = 0.05;
  const auto density = source_search::source_density(belief, kResolutionM);
  std::string text = "x_m,y_m,density_per_m2\n";
  for (std::size_t i = 0; i < density.size(); ++i) {
    if (density[i] > 0.0F) {
      const Eigen::Vector2d at_m = density.center_m(density.cell(i));
      text += fmt::format("{:.3f},{:.3f},{:.4g}\n", at_m.x(), at_m.y(), density[i]);
    }
  }
  files::write_text_file(path, text);
}

}  // namespace echomap::apps

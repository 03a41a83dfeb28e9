// SPDX-License-Identifier: MIT
#include "tests/benchmarks/carried_runs.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "host/session/child_process.hpp"
#include "tests/benchmarks/reliability.hpp"
#include "tests/benchmarks/room_symmetry.hpp"
#include "tests/support/median.hpp"

namespace echomap::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes kPatienceWithCarried(40);
constexpr const char* kLocalized = "localized";

ToldPlace told_place_of(const nlohmann::json& stop) {
  ToldPlace told{stop.at("status") == kLocalized, stop.at("lost_probability"), std::nullopt};
  if (!stop.at("error_m").is_null()) {
    told.error = evaluation::PlaceError{stop.at("error_m"), stop.at("heading_error_rad")};
  }
  return told;
}

/// What is counted of the runs of a room, or of all.
struct CarriedCount {
  std::size_t runs = 0;
  std::size_t found = 0;
  std::size_t wrong = 0;
  std::size_t ambiguous = 0;
  std::size_t told_ambiguous = 0;
  std::size_t claims = 0;
  std::size_t wrong_claims = 0;
  std::optional<double> symmetry_rad;
  std::vector<double> stops;
  std::vector<double> errors_m;                ///< Of those found.
  std::map<std::string, std::size_t> not_run;  ///< By why.
  Reliability reliability;

  void add(const CarriedRun& run) {
    symmetry_rad = run.symmetry_rad;
    if (!run.has_run()) {
      ++not_run[run.why_not];
      return;
    }
    ++runs;
    found += run.is_found() ? 1 : 0;
    wrong += run.ended == kLocalized && !run.is_found() ? 1 : 0;
    ambiguous += run.ended == "ambiguous" ? 1 : 0;
    told_ambiguous += run.is_told_ambiguous() ? 1 : 0;
    stops.push_back(static_cast<double>(run.told.size()));
    if (run.is_found()) {
      errors_m.push_back(run.told.back().error->error_m);
    }
    for (const ToldPlace& told : run.told) {
      claims += told.is_claim() ? 1 : 0;
      wrong_claims += told.is_claim() && !told.is_right() ? 1 : 0;
      reliability.add(told.lost_probability, !told.is_right());
    }
  }
};

std::string words_of_not_run(const CarriedCount& count) {
  std::string words;
  for (const auto& [why, runs] : count.not_run) {
    words += fmt::format("{}{}: {}", words.empty() ? "" : "; ", runs, why);
  }
  return words;
}

std::vector<std::string> row_of(const std::string& room, const CarriedCount& count) {
  const auto text = [](const std::vector<double>& values, double unit, const char* format) {
    return values.empty() ? "-" : fmt::format(fmt::runtime(format), tests::median(values) / unit);
  };
  return {room,
          count.symmetry_rad ? fmt::format("{:.0f}°", geometry::degrees(*count.symmetry_rad)) : "",
          fmt::format("{} of {}", count.found, count.runs),
          std::to_string(count.wrong),
          std::to_string(count.ambiguous),
          std::to_string(count.runs - count.found - count.wrong - count.ambiguous),
          fmt::format("{} of {}", count.wrong_claims, count.claims),
          text(count.stops, 1.0, "{:.0f}"),
          text(count.errors_m, 0.01, "{:.0f} cm"),
          words_of_not_run(count)};
}

void print_carried(const CarriedRun& run) {
  std::string words = run.has_run() ? run.ended : "NOT RUN, " + run.why_not;
  if (run.has_run() && run.ended == kLocalized) {
    words += run.is_found() ? ", right" : ", WRONG";
  }
  fmt::print(stderr,
             "{:14} seed {:3} {}{}:",
             run.room,
             run.seed,
             run.symmetry_rad ? "looks alike, " : "",
             words);
  for (const ToldPlace& told : run.told) {
    fmt::print(stderr,
               " {}{:.2f}{}",
               told.is_claim() ? "claim " : "",
               told.lost_probability,
               told.is_right() ? "+" : "-");
  }
  fmt::print(stderr, "\n");
}

void add_share(std::vector<Figure>& figures,
               const std::string& name,
               std::size_t part,
               std::size_t all) {
  if (all > 0) {
    figures.push_back(
        {name, static_cast<double>(part) / static_cast<double>(all), "share", all, {}});
  }
}

}  // namespace

bool ToldPlace::is_claim() const {
  constexpr double kClaimed = 0.05;
  return is_localized && lost_probability <= kClaimed;
}

bool CarriedRun::is_found() const {
  return ended == kLocalized && !told.empty() && told.back().is_right();
}

bool CarriedRun::is_told_ambiguous() const {
  const bool claims_wrongly = std::any_of(told.begin(), told.end(), [](const ToldPlace& place) {
    return place.is_claim() && !place.is_right();
  });
  return !claims_wrongly && (ended == "ambiguous" || is_found());
}

CarriedRun read_carried(CarriedRun run, const std::string& report_json) {
  const auto report = nlohmann::json::parse(report_json);
  if (!report.contains("kidnap")) {
    run.why_not = "no finished map (" + report.at("outcome").get<std::string>() + ")";
    return run;
  }
  const auto& kidnap = report.at("kidnap");
  if (kidnap.at("stops_told").empty()) {
    run.why_not = "the drive ended before";
    return run;
  }
  if (kidnap.at("carried_m") < evaluation::kRightPlaceM) {
    run.why_not = "no other place in the room";
    return run;
  }
  run.ended = kidnap.at("ended");
  for (const auto& stop : kidnap.at("stops_told")) {
    run.told.push_back(told_place_of(stop));
  }
  return run;
}

CarriedRun carry_off(const TruthRoom& room,
                     const TruthRobot& robot,
                     int seed,
                     const fs::path& folder) {
  fs::create_directories(folder);
  CarriedRun run{room.name, symmetry_turn_rad(room.plan), seed, "", "", {}};
  try {
    session::ChildProcess program(demo_command(room, robot, seed, true, folder),
                                  folder / "demo.log");
    program.wait_for(kPatienceWithCarried);
    run = read_carried(run, files::read_text_file(folder / "report.json"));
  } catch (const std::exception& error) {
    run.why_not = "no report";
    fmt::print(stderr, "{}, seed {}: {}\n", room.name, seed, error.what());
  }
  print_carried(run);
  return run;
}

std::vector<Figure> carried_figures(const std::vector<CarriedRun>& runs) {
  CarriedCount all;
  CarriedCount distinct;
  CarriedCount alike;
  for (const CarriedRun& run : runs) {
    all.add(run);
    (run.symmetry_rad ? alike : distinct).add(run);
  }
  std::vector<Figure> figures;
  add_share(figures, "own_map_found", distinct.found, distinct.runs);
  add_share(figures, "wrong_claims", all.wrong_claims, all.claims);
  add_share(figures, "ambiguous_told", alike.told_ambiguous, alike.runs);
  if (all.reliability.count() > 0) {
    figures.push_back(
        {"reliability_gap", all.reliability.mean_error(), "", all.reliability.count(), {}});
  }
  figures.push_back(
      {"carried_not_run", static_cast<double>(runs.size() - all.runs), "", runs.size(), {}});
  return figures;
}

MarkdownTable carried_table(const std::vector<CarriedRun>& runs) {
  std::vector<std::pair<std::string, CarriedCount>> rooms;
  for (const CarriedRun& run : runs) {
    if (rooms.empty() || rooms.back().first != run.room) {
      rooms.emplace_back(run.room, CarriedCount());
    }
    rooms.back().second.add(run);
  }
  MarkdownTable table{{"room",
                       "looks alike",
                       "right",
                       "wrong",
                       "ambiguous",
                       "not localized",
                       "wrong claims",
                       "stops",
                       "error",
                       "not run"},
                      {}};
  for (const auto& [room, count] : rooms) {
    table.rows.push_back(row_of(room, count));
  }
  return table;
}

}  // namespace echomap::bench

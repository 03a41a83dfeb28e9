// SPDX-License-Identifier: MIT
#include "host/apps/localize_places.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/apps/report.hpp"
#include "host/apps/run_ending.hpp"
#include "host/apps/whole_records.hpp"
#include "host/console/print.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "host/localization/place_recognition.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;
using localization::RecognisedPlace;
using localization::RoundScan;

constexpr std::string_view kPrefix = "places=";

/// A place with the sweep that was taken there.
struct LearnedPlace {
  std::string name;
  RoundScan scan;
};

/// The ranges of a sweep in even steps all round. Throws CommandError where it is none.
RoundScan all_round(const sensors::RangeScan& scan, const fs::path& file) {
  RoundScan ranges_m;
  const double step_rad = geometry::kFullTurnRad / static_cast<double>(scan.beams.size());
  for (const sensors::Beam& beam : scan.beams) {
    const double even_rad = step_rad * static_cast<double>(ranges_m.size());
    constexpr double kRoundingRad = 1e-3;
    if (std::abs(geometry::angle_between(even_rad, beam.bearing_rad)) > kRoundingRad) {
      throw CommandError(ExitCode::kRuntimeError,
                         file.string() +
                             " does not look all round in even steps from ahead on\n"
                             "  next: name a sweep that does, as a LEGO NXT's (--format nxt)");
    }
    ranges_m.push_back(beam.range_m);
  }
  return ranges_m;
}

/// The first sweep of a log, whose beams go once round.
RoundScan round_scan_of(const fs::path& file, const std::string& format) {
  const auto log = open_reported_log(file, format);
  while (const auto record = next_whole_record(*log)) {
    if (const auto* scan = std::get_if<sensors::RangeScan>(&*record)) {
      return all_round(*scan, file);
    }
  }
  throw files::FileError(file.string() + " holds no sweep");
}

std::vector<LearnedPlace> read_places(const fs::path& folder, const std::string& format) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  std::vector<LearnedPlace> places;
  for (const fs::path& file : files) {
    places.push_back({file.stem().string(), round_scan_of(file, format)});
  }
  if (places.empty()) {
    throw CommandError(
        ExitCode::kRuntimeError,
        folder.string() + " has no place\n  next: put the sweep of each place there, a file each");
  }
  return places;
}

/// Where ranges differ by more in the mean, it is no place that was learned; ours.
constexpr double kMaxDifferenceM = 0.25;

/// Where the next place fits by more than 5 % worse; ours.
bool is_told_apart(const RecognisedPlace& found, std::size_t places) {
  constexpr double kMargin = 1.05;
  return places == 1 || found.next_difference_m > kMargin * found.difference_m;
}

RunEnding ending_of_recognition(const RecognisedPlace& found,
                                const std::vector<LearnedPlace>& places) {
  const std::string& name = places[found.place].name;
  if (found.difference_m > kMaxDifferenceM) {
    return {"finished",
            ExitCode::kUnfinished,
            "no learned place fits: the nearest is " + name,
            "learn this place, too: put its sweep into the folder"};
  }
  if (is_told_apart(found, places.size())) {
    return {"finished",
            ExitCode::kOk,
            "the sweep was taken at " + name,
            "sweep again elsewhere, or learn another place: a file more in its folder"};
  }
  return {"finished",
          ExitCode::kUnfinished,
          "ambiguous: another place fits nearly as well as " + name,
          "sweep again some steps away, or learn places that look less alike"};
}

}  // namespace

std::optional<fs::path> places_of(const fs::path& map) {
  const std::string text = map.string();
  return text.starts_with(kPrefix) ? std::optional<fs::path>(text.substr(kPrefix.size()))
                                   : std::nullopt;
}

ExitCode localize_in_places(const LocalizeOptions& options, const fs::path& out) {
  const auto places = read_places(places_of(options.map).value(), options.format);
  const RoundScan scan = round_scan_of(options.log, options.format);
  std::vector<RoundScan> learned;
  for (const LearnedPlace& place : places) {
    if (place.scan.size() != scan.size()) {
      throw CommandError(ExitCode::kRuntimeError,
                         fmt::format("{} has {} readings and the sweep of {} has {}\n"
                                     "  next: sweep both in the same steps",
                                     place.name,
                                     place.scan.size(),
                                     options.log.string(),
                                     scan.size()));
    }
    learned.push_back(place.scan);
  }
  const RecognisedPlace found = localization::recognise_place(scan, learned).value();
  const RunEnding ending = ending_of_recognition(found, places);
  const double turn_deg = geometry::degrees(found.turn_rad);
  nlohmann::ordered_json report = to_json(ending);
  report.update({{"log", options.log.filename().string()},
                 {"place", places[found.place].name},
                 {"turn_deg", turn_deg},
                 {"difference_m", found.difference_m},
                 {"places", places.size()}});
  if (places.size() > 1) {
    report["next_difference_m"] = found.next_difference_m;
  }
  write_report(out / "summary.json", report);
  write_report(options.run.json, report);
  console::print(fmt::format("{}, turned by {:.0f} degrees: ranges differ by {:.1f} cm",
                             places[found.place].name,
                             turn_deg,
                             100.0 * found.difference_m));
  print_ending(ending, "the report");
  return ending.code;
}

}  // namespace echomap::apps

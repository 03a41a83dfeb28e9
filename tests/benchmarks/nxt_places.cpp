// SPDX-License-Identifier: MIT
#include "tests/benchmarks/nxt_places.hpp"

#include <string>

#include "host/datasets/nxt_scan_log.hpp"
#include "host/localization/place_recognition.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/log_files.hpp"

namespace echomap::bench {

namespace {

constexpr std::size_t kPlaces = 5;

localization::RoundScan read_scan(const std::filesystem::path& path) {
  localization::RoundScan scan;
  const auto records = tests::records_of(*datasets::open_nxt_scan_log(path));
  for (const auto& all_round : tests::only<sensors::RangeScan>(records)) {
    for (const sensors::Beam& beam : all_round.beams) {
      scan.push_back(beam.range_m);
    }
  }
  return scan;
}

}  // namespace

int nxt_places_known_again(const std::filesystem::path& folder) {
  std::vector<localization::RoundScan> places;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    places.push_back(read_scan(folder / ("place_train_loc_0" + std::to_string(i) + ".dat")));
  }
  int known = 0;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    const auto scan = read_scan(folder / ("place_test_loc_0" + std::to_string(i) + ".dat"));
    known += localization::recognise_place(scan, places)->place == i ? 1 : 0;
  }
  return known;
}

}  // namespace echomap::bench

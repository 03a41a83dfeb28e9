// SPDX-License-Identifier: MIT
#include "host/strategies/stop_list_file.hpp"

#include <cmath>

#include <fmt/format.h>

namespace echomap::strategies {
namespace {

/// As far as rooms reach: a typing error shall not send a robot out of its room.
constexpr double kMaxCoordinateM = 100.0;

double coordinate_m(const files::TomlReader& place, std::string_view key) {
  const double value_m = place.number(key);
  if (std::abs(value_m) > kMaxCoordinateM) {
    place.fail(key,
               fmt::format("'{}' must be from -{} to {}", key, kMaxCoordinateM, kMaxCoordinateM));
  }
  return value_m;
}

}  // namespace

std::vector<exploration::TourPlace> read_stop_list(const files::TomlReader& file) {
  std::vector<exploration::TourPlace> places;
  for (const files::TomlReader& place : file.tables("place")) {
    places.push_back({place.text_or("name", ""),
                      {coordinate_m(place, "x_m"), coordinate_m(place, "y_m")},
                      place.boolean_or("sweep", true)});
  }
  if (places.empty()) {
    file.fail("place", "a stop list has one [[place]] or more");
  }
  file.reject_unknown_keys();
  return places;
}

std::vector<exploration::TourPlace> load_stop_list(const std::filesystem::path& path) {
  return read_stop_list(files::TomlReader::load(path));
}

}  // namespace echomap::strategies

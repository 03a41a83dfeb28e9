// SPDX-License-Identifier: MIT
#include "host/exports/map_yaml.hpp"

#include <array>
#include <sstream>

#include <fmt/format.h>

#include "host/exports/number_table.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::exports {

namespace {

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\"'[");
  const std::size_t end = text.find_last_not_of(" \t\r\"']");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

/// One file being read: knows where it is when something is wrong.
class YamlLines {
 public:
  explicit YamlLines(const std::filesystem::path& path)
      : path_(path), lines_(files::read_text_file(path)) {}

  /// Moves to the next `key: value` line.
  bool next() {
    for (std::string line; std::getline(lines_, line);) {
      ++line_number_;
      const std::string text = trimmed(line.substr(0, line.find('#')));
      const std::size_t colon = text.find(':');
      if (text.empty()) {
        continue;
      }
      if (colon == std::string::npos) {
        fail("expected `key: value`");
      }
      key = trimmed(text.substr(0, colon));
      value = trimmed(text.substr(colon + 1));
      return true;
    }
    return false;
  }

  double number(const std::string& text) const {
    const std::string field = trimmed(text);
    const auto number = parse_number(field);
    if (!number) {
      fail("'" + field + "' is not a finite number");
    }
    return *number;
  }

  /// The value as `[x, y, yaw]`.
  std::array<double, 3> triple() const {
    std::array<double, 3> numbers{};
    std::istringstream fields(value);
    std::string field;
    for (double& entry : numbers) {
      if (!std::getline(fields, field, ',')) {
        fail("expected [x, y, yaw]");
      }
      entry = number(field);
    }
    return numbers;
  }

  [[noreturn]] void fail(const std::string& message) const {
    fail_at_line(path_, line_number_, message);
  }

  std::string key;
  std::string value;

 private:
  std::filesystem::path path_;
  std::istringstream lines_;
  std::size_t line_number_ = 0;
};

void take_origin(const YamlLines& lines, MapYaml& yaml) {
  const auto [x_m, y_m, yaw_rad] = lines.triple();
  if (yaw_rad != 0.0) {
    lines.fail("a rotated origin is not supported");
  }
  yaml.origin_m = {x_m, y_m};
}

/// In mode `raw` a pixel goes by no threshold.
void demand_thresholds(const YamlLines& lines) {
  if (lines.value != "trinary" && lines.value != "scale") {
    lines.fail("mode '" + lines.value + "' is not supported, only trinary and scale");
  }
}

void take(const YamlLines& lines, MapYaml& yaml) {
  if (lines.key == "image") {
    yaml.image = lines.value;
  } else if (lines.key == "mode") {
    demand_thresholds(lines);
  } else if (lines.key == "resolution") {
    yaml.resolution_m = lines.number(lines.value);
  } else if (lines.key == "origin") {
    take_origin(lines, yaml);
  } else if (lines.key == "negate") {
    yaml.negate = lines.number(lines.value) != 0.0;
  } else if (lines.key == "occupied_thresh") {
    yaml.occupied_threshold = lines.number(lines.value);
  } else if (lines.key == "free_thresh") {
    yaml.free_threshold = lines.number(lines.value);
  }
}

}  // namespace

void write_map_yaml(const std::filesystem::path& path, const MapYaml& yaml) {
  files::write_text_file(path,
                         fmt::format("image: {}\nmode: trinary\nresolution: {:.9g}\n"
                                     "origin: [{:.9g}, {:.9g}, 0]\nnegate: {:d}\n"
                                     "occupied_thresh: {:.9g}\nfree_thresh: {:.9g}\n",
                                     yaml.image,
                                     yaml.resolution_m,
                                     yaml.origin_m.x(),
                                     yaml.origin_m.y(),
                                     yaml.negate,
                                     yaml.occupied_threshold,
                                     yaml.free_threshold));
}

MapYaml read_map_yaml(const std::filesystem::path& path) {
  YamlLines lines(path);
  MapYaml yaml;
  while (lines.next()) {
    take(lines, yaml);
  }
  if (yaml.image.empty() || !(yaml.resolution_m > 0.0)) {
    lines.fail("the file names no image or no resolution above 0");
  }
  return yaml;
}

}  // namespace echomap::exports

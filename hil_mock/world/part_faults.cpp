// SPDX-License-Identifier: MIT
#include "hil_mock/world/part_faults.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "host/files/nearest_word.hpp"

namespace echomap::world {
namespace {

/// A kind, its value where none is named, the least and the largest one, and how long it is where
/// that is not named.
struct KindRow {
  PartFaultKind kind;
  std::string_view name;
  double usual = 0.0;
  double least = 0.0;
  double most = 0.0;
  double usual_for_s = std::numeric_limits<double>::infinity();
};

/// Optiboot's, of the Uno, before it starts the program.
constexpr double kBootLoaderS = 1.0;

constexpr std::array kKinds{
    KindRow{PartFaultKind::kEncoderLeft, "encoder-left"},
    KindRow{PartFaultKind::kEncoderRight, "encoder-right"},
    KindRow{PartFaultKind::kSonarDead, "sonar-dead"},
    KindRow{PartFaultKind::kSonarStuck, "sonar-stuck", 0.5, 0.0, 10.0},
    KindRow{PartFaultKind::kSlipLeft, "slip-left", 0.3, 0.0, 1.0},
    KindRow{PartFaultKind::kSlipRight, "slip-right", 0.3, 0.0, 1.0},
    KindRow{PartFaultKind::kBatteryLow, "battery-low", 0.05, 0.0, 1.0},
    KindRow{PartFaultKind::kBoardReset, "board-reset", 0.0, 0.0, 0.0, kBootLoaderS},
    KindRow{PartFaultKind::kMotorLeftReversed, "motor-left-reversed"},
    KindRow{PartFaultKind::kMotorRightReversed, "motor-right-reversed"},
    KindRow{PartFaultKind::kEncoderLeftReversed, "encoder-left-reversed"},
    KindRow{PartFaultKind::kEncoderRightReversed, "encoder-right-reversed"},
    KindRow{PartFaultKind::kMotorsSwapped, "motors-swapped"},
    KindRow{PartFaultKind::kEncodersSwapped, "encoders-swapped"},
    KindRow{PartFaultKind::kCounts, "counts", 0.5, 0.25, 4.0},
    KindRow{PartFaultKind::kWheelLeft, "wheel-left", 1.08, 0.5, 2.0},
    KindRow{PartFaultKind::kWheelRight, "wheel-right", 1.08, 0.5, 2.0},
    KindRow{PartFaultKind::kPanReversed, "pan-reversed"},
    KindRow{PartFaultKind::kPanOff, "pan-off", 7.0, -90.0, 90.0},
    KindRow{PartFaultKind::kEncoderLeftDirty, "encoder-left-dirty", 0.01, 0.0, 1.0},
    KindRow{PartFaultKind::kEncoderRightDirty, "encoder-right-dirty", 0.01, 0.0, 1.0},
    KindRow{PartFaultKind::kSonarHigh, "sonar-high"},
    KindRow{PartFaultKind::kSonarSlow, "sonar-slow", 0.2, 0.038, 1.0},
    KindRow{PartFaultKind::kContactLeftBroken, "contact-left-broken"},
    KindRow{PartFaultKind::kContactRightBroken, "contact-right-broken"},
    KindRow{PartFaultKind::kRangeScale, "range-scale", 1.1, 0.5, 2.0}};

[[noreturn]] void refuse(const std::string& fault, const std::string& why) {
  throw std::invalid_argument("part fault '" + fault + "': " + why);
}

const KindRow& kind_of(const std::string& fault, const std::string& name) {
  const auto found = std::find_if(
      kKinds.begin(), kKinds.end(), [&](const KindRow& row) { return row.name == name; });
  if (found == kKinds.end()) {
    refuse(fault, "unknown part '" + name + "'" + files::suggestion(name, part_fault_names()));
  }
  return *found;
}

double number_in(const std::string& fault, const std::string& text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end || std::isnan(number)) {
    refuse(fault, "'" + text + "' is no number");
  }
  return number;
}

double seconds_in(const std::string& fault, const std::string& text) {
  const double seconds = number_in(fault, text);
  if (seconds < 0.0) {
    refuse(fault, "'" + text + "' is no time: it takes seconds, 0 or more");
  }
  return seconds;
}

double value_in(const std::string& fault, const std::string& text, const KindRow& row) {
  const double value = number_in(fault, text);
  if (row.least == row.most) {
    refuse(fault, "it takes no value");
  }
  if (value < row.least || value > row.most) {
    std::ostringstream bounds;
    bounds << "its value is from " << row.least << " to " << row.most;
    refuse(fault, bounds.str());
  }
  return value;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> pieces;
  std::istringstream rest(text);
  for (std::string piece; std::getline(rest, piece, at);) {
    pieces.push_back(piece);
  }
  return pieces;
}

PartFault parse_one(const std::string& text) {
  const std::size_t at = text.find('@');
  if (at == std::string::npos) {
    refuse(text, "it takes NAME@AT, NAME@AT:FOR or NAME@AT:FOR:VALUE");
  }
  const KindRow& row = kind_of(text, text.substr(0, at));
  const std::vector<std::string> numbers = split(text.substr(at + 1), ':');
  if (numbers.empty() || numbers.size() > 3) {
    refuse(text, "it takes NAME@AT, NAME@AT:FOR or NAME@AT:FOR:VALUE");
  }
  PartFault fault{row.kind, seconds_in(text, numbers[0]), row.usual_for_s, row.usual};
  if (!std::isfinite(fault.at_s)) {
    refuse(text, "it has to begin at some time");
  }
  if (numbers.size() > 1) {
    fault.for_s = seconds_in(text, numbers[1]);
  }
  if (numbers.size() > 2) {
    fault.value = value_in(text, numbers[2], row);
  }
  return fault;
}

}  // namespace

std::vector<PartFault> parse_part_faults(const std::string& text) {
  std::vector<PartFault> faults;
  for (const std::string& piece : split(text, ',')) {
    faults.push_back(parse_one(piece));
  }
  return faults;
}

std::string_view name_of(PartFaultKind kind) {
  const auto found = std::find_if(
      kKinds.begin(), kKinds.end(), [&](const KindRow& row) { return row.kind == kind; });
  return found->name;
}

std::vector<std::string> part_fault_names() {
  std::vector<std::string> names;
  names.reserve(kKinds.size());
  for (const KindRow& row : kKinds) {
    names.emplace_back(row.name);
  }
  return names;
}

std::optional<double> fault_at(const std::vector<PartFault>& faults,
                               PartFaultKind kind,
                               double now_s) {
  for (const PartFault& fault : faults) {
    if (fault.kind == kind && now_s >= fault.at_s && now_s < fault.at_s + fault.for_s) {
      return fault.value;
    }
  }
  return std::nullopt;
}

}  // namespace echomap::world

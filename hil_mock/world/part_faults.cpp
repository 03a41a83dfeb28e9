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

/// A kind, its value where none is named, the largest one, and how long it is where that is not
/// named.
struct KindRow {
  PartFaultKind kind;
  std::string_view name;
  double usual;
  double most;
  double usual_for_s = std::numeric_limits<double>::infinity();
};

/// Optiboot's, of the Uno, before it starts the program.
constexpr double kBootLoaderS = 1.0;

constexpr std::array kKinds{
    KindRow{PartFaultKind::kEncoderLeft, "encoder-left", 0.0, 0.0},
    KindRow{PartFaultKind::kEncoderRight, "encoder-right", 0.0, 0.0},
    KindRow{PartFaultKind::kSonarDead, "sonar-dead", 0.0, 0.0},
    KindRow{PartFaultKind::kSonarStuck, "sonar-stuck", 0.5, 10.0},
    KindRow{PartFaultKind::kSlipLeft, "slip-left", 0.3, 1.0},
    KindRow{PartFaultKind::kSlipRight, "slip-right", 0.3, 1.0},
    KindRow{PartFaultKind::kBatteryLow, "battery-low", 0.05, 1.0},
    KindRow{PartFaultKind::kBoardReset, "board-reset", 0.0, 0.0, kBootLoaderS}};

[[noreturn]] void refuse(const std::string& fault, const std::string& why) {
  throw std::invalid_argument("part fault '" + fault + "': " + why);
}

const KindRow& kind_of(const std::string& fault, const std::string& name) {
  const auto found = std::find_if(
      kKinds.begin(), kKinds.end(), [&](const KindRow& row) { return row.name == name; });
  if (found == kKinds.end()) {
    std::vector<std::string> names;
    names.reserve(kKinds.size());
    for (const KindRow& row : kKinds) {
      names.emplace_back(row.name);
    }
    refuse(fault, "unknown part '" + name + "'" + files::suggestion(name, names));
  }
  return *found;
}

double number_in(const std::string& fault, const std::string& text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end || !(number >= 0.0)) {
    refuse(fault, "'" + text + "' is no number of 0 or more");
  }
  return number;
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
  PartFault fault{row.kind, number_in(text, numbers[0]), row.usual_for_s, row.usual};
  if (!std::isfinite(fault.at_s)) {
    refuse(text, "it has to begin at some time");
  }
  if (numbers.size() > 1) {
    fault.for_s = number_in(text, numbers[1]);
  }
  if (numbers.size() > 2) {
    fault.value = number_in(text, numbers[2]);
    if (row.most == 0.0) {
      refuse(text, "it takes no value");
    }
    if (fault.value > row.most) {
      refuse(text,
             "its value is " + std::string(row.most == 1.0 ? "a share, 0 to 1" : "too large"));
    }
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

// SPDX-License-Identifier: MIT
#include "hil_mock/line_faults/faulty_line.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace echomap::line_faults {
namespace {

/// A number of each direction's two streams, so that none repeats another's draws.
enum class Stream : std::uint32_t { kFrames = 0, kBytes = 1 };

world::NoiseStream noise_for(std::uint32_t seed, Direction direction, Stream stream) {
  const std::uint32_t number =
      2 * static_cast<std::uint32_t>(direction) + static_cast<std::uint32_t>(stream);
  return {4 * seed + number, world::NoisePurpose::kLineFaults};
}

template <class Number>
Number read_number(std::string_view name, std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw std::invalid_argument(std::string(name) + "=" + std::string(text) +
                                ": not a number that fits");
  }
  return number;
}

double read_share(std::string_view name, std::string_view text) {
  const auto share = read_number<double>(name, text);
  const bool is_share = share >= 0.0 && share <= 1.0;
  if (!is_share) {
    throw std::invalid_argument(std::string(name) + "=" + std::string(text) +
                                ": it must be in 0 .. 1");
  }
  return share;
}

Absence read_absence(std::string_view name, std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view until = colon == std::string_view::npos ? "" : text.substr(colon + 1);
  const Absence absence{read_number<double>(name, text.substr(0, colon)),
                        read_number<double>(name, until)};
  const bool is_sound = absence.at_s >= 0.0 && absence.for_s >= 0.0;
  if (!is_sound) {
    throw std::invalid_argument(std::string(name) + "=" + std::string(text) +
                                ": it takes AT:FOR in seconds, as in away=60:5");
  }
  return absence;
}

}  // namespace

LineFaults parse_line_faults(const std::string& text) {
  LineFaults faults;
  const std::map<std::string, double*> shares{{"flip", &faults.rates.flip},
                                              {"drop", &faults.rates.drop},
                                              {"insert", &faults.rates.insert},
                                              {"burst", &faults.rates.burst},
                                              {"cut", &faults.rates.cut},
                                              {"loss", &faults.loss}};
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t equals = part.find('=');
    const std::string name = part.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : part.substr(equals + 1);
    if (name == "seed") {
      faults.seed = read_number<std::uint32_t>(name, value);
    } else if (name == "away") {
      faults.away.push_back(read_absence(name, value));
    } else if (const auto share = shares.find(name); share != shares.end()) {
      *share->second = read_share(name, value);
    } else {
      throw std::invalid_argument("'" + part +
                                  "': expected flip, drop, insert, burst, cut, loss, away or seed, "
                                  "as in flip=1e-4,loss=0.01,seed=3");
    }
  }
  FaultyLine(faults, Direction::kToRobot);
  return faults;
}

bool is_away(const LineFaults& faults, double now_s) {
  return std::any_of(faults.away.begin(), faults.away.end(), [&](const Absence& absence) {
    return now_s >= absence.at_s && now_s < absence.at_s + absence.for_s;
  });
}

FaultyLine::FaultyLine(const LineFaults& faults, Direction direction)
    : frames_(faults.loss, noise_for(faults.seed, direction, Stream::kFrames)),
      bytes_(faults.rates, noise_for(faults.seed, direction, Stream::kBytes)) {}

}  // namespace echomap::line_faults

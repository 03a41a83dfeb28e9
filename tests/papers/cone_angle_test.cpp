// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/datasets/nxt_scan_log.hpp"
#include "host/geometry/angle.hpp"
#include "host/papers/square_room.hpp"
#include "host/sensors/range_scan.hpp"
#include "host/sensors/wall_beam_width.hpp"
#include "tests/papers/post_beam_width.hpp"
#include "tests/support/log_files.hpp"
#include "tests/support/real_data.hpp"

// Hennessey et al., section III.A: the cone of a small sonar opens by 32.8 +- 9.6 degrees. Here
// from sweeps of the simulated sonar, whose cone is known, and from sonars of others.
namespace echomap::papers {
namespace {

using geometry::degrees;
using geometry::radians;
using sensors::Beam;
using sensors::BeamWidth;

constexpr double kPaperDeg = 32.8;
constexpr double kPaperBoundDeg = 9.6;
constexpr std::uint32_t kSweepSeeds = 20;

bool holds(const BeamWidth& opening, double truth_rad) {
  return opening.low_rad <= truth_rad && truth_rad <= opening.high_rad;
}

void expect_within_paper(double beam_width_rad) {
  EXPECT_NEAR(degrees(beam_width_rad), kPaperDeg, kPaperBoundDeg);
}

/// A hall of 8 x 8 m, rough walls, the sonar in the middle.
world::Outline hall() {
  const std::vector<world::Surface> rough(4, {world::Material::kRough, 0.9});
  return {{{-4.0, -4.0}, {4.0, -4.0}, {4.0, 4.0}, {-4.0, 4.0}}, rough};
}

/// An eight-sided post, 2 cm thick, 0.8 m ahead.
world::FloorPlan post_in_a_hall() {
  world::Outline post{{}, std::vector<world::Surface>(8, {world::Material::kRough, 0.9})};
  for (int i = 0; i < 8; ++i) {
    const double bearing_rad = radians(45.0 * i);
    post.corners_m.emplace_back(0.8 + 0.01 * std::cos(bearing_rad), 0.01 * std::sin(bearing_rad));
  }
  return {"post", hall(), {post}, {}};
}

/// How often over the seeds, and how far off on average.
struct Rates {
  int found = 0;
  int held = 0;  ///< The true opening lay between the bounds.
  double mean_deg = 0.0;
  double worst_deg = 0.0;
};

void count(Rates& rates, const std::optional<BeamWidth>& opening, double truth_deg) {
  if (!opening) {
    return;
  }
  const double found_deg = degrees(opening->beam_width_rad);
  ++rates.found;
  rates.held += holds(*opening, radians(truth_deg)) ? 1 : 0;
  rates.mean_deg += (found_deg - rates.mean_deg) / rates.found;
  rates.worst_deg = std::max(rates.worst_deg, std::abs(found_deg - truth_deg));
}

void print(const std::string& what, const Rates& rates) {
  std::cout << what << ": found " << rates.found << ", within its bounds " << rates.held << " of "
            << kSweepSeeds << ", mean " << rates.mean_deg << ", worst " << rates.worst_deg
            << " degrees off\n";
}

/// There and back, a degree a step.
std::vector<sensors::Beam> double_sweep(const world::FloorPlan& plan,
                                        const world::SonarParams& sonar,
                                        std::uint32_t seed) {
  auto readings = sweep(plan, sonar, {radians(60.0), radians(1.0)}, seed);
  const auto back = sweep(plan, sonar, {radians(60.0), radians(1.0)}, seed + kSweepSeeds);
  readings.insert(readings.end(), back.begin(), back.end());
  return readings;
}

TEST(ConeAngle, IsFoundBySweepingPastAPost) {
  const world::FloorPlan plan = post_in_a_hall();
  for (const double beam_width_deg : {20.0, kPaperDeg, 42.0}) {
    Rates rates;
    for (std::uint32_t seed = 1; seed <= kSweepSeeds; ++seed) {
      count(rates,
            beam_width_past_post(double_sweep(plan, ev3_sonar(radians(beam_width_deg)), seed),
                                 {0.79, 0.05, 0.02}),
            beam_width_deg);
    }
    print("post, " + std::to_string(beam_width_deg), rates);
    EXPECT_EQ(rates.found, static_cast<int>(kSweepSeeds));
    EXPECT_GE(rates.held, static_cast<int>(kSweepSeeds * 9 / 10));
    EXPECT_NEAR(rates.mean_deg, beam_width_deg, 1.5);
  }
}

// The mean of 42 degrees comes out 2 degrees narrow: its edge is soft, and soft edges look narrow.
TEST(ConeAngle, IsFoundFromTheWallsOfASquareRoom) {
  const world::FloorPlan plan = square_room();
  for (const double beam_width_deg : {20.0, kPaperDeg, 42.0}) {
    Rates rates;
    for (std::uint32_t seed = 1; seed <= kSweepSeeds; ++seed) {
      const auto pooled =
          sensors::pooled_beam_width(walls_of_room(plan, ev3_sonar(radians(beam_width_deg)), seed));
      count(rates, pooled ? std::optional(pooled->mean) : std::nullopt, beam_width_deg);
    }
    print("walls, " + std::to_string(beam_width_deg), rates);
    EXPECT_EQ(rates.found, static_cast<int>(kSweepSeeds));
    if (beam_width_deg < 40.0) {
      EXPECT_GE(rates.held, static_cast<int>(kSweepSeeds * 8 / 10));
    }
    EXPECT_NEAR(rates.mean_deg, beam_width_deg, 2.5);
    EXPECT_LT(rates.worst_deg, kPaperBoundDeg);
  }
}

TEST(ConeAngle, OfTheNxtSonarIsThePapers) {
  std::vector<sensors::SweptWall> walls;
  for (const char* set : {"train", "test"}) {
    for (int place = 0; place < 5; ++place) {
      const auto path = tests::real_data("nxt_sonar_imperial") /
                        ("place_" + std::string(set) + "_loc_0" + std::to_string(place) + ".dat");
      ECHOMAP_SKIP_WITHOUT(path);
      const auto records = tests::records_of(*datasets::open_nxt_scan_log(path));
      std::vector<sensors::Beam> readings;
      const auto scan = tests::only<sensors::RangeScan>(records).at(0);
      for (const sensors::Beam& beam : scan.beams) {
        readings.push_back({beam.bearing_rad, beam.range_m});
      }
      const auto found = sensors::swept_walls(readings);
      walls.insert(walls.end(), found.begin(), found.end());
    }
  }
  const auto pooled = sensors::pooled_beam_width(walls);
  ASSERT_TRUE(pooled);
  std::cout << "NXT: " << walls.size() << " walls, " << degrees(pooled->mean.beam_width_rad)
            << " +- " << degrees(pooled->spread_rad) << " degrees, mean within "
            << degrees(pooled->mean.low_rad) << " to " << degrees(pooled->mean.high_rad) << "\n";
  EXPECT_GE(walls.size(), 20U);
  expect_within_paper(pooled->mean.low_rad);
  expect_within_paper(pooled->mean.high_rad);
}

/// A card before an HC-SR04, by the pair of columns that holds it.
struct Card {
  const char* name;
  std::size_t column;
  double range_m;
};
constexpr std::array<Card, 5> kCards = {{{"upright 2 cm", 0, 0.02},
                                         {"upright 4 cm", 3, 0.04},
                                         {"upright 6 cm", 6, 0.06},
                                         {"upright 10 cm", 9, 0.10},
                                         {"flat 5 cm", 12, 0.05}}};

/// Rows are angle and reading in centimetres by turns, some empty at a column's end.
std::vector<sensors::Beam> tilts_of(const std::string& path, std::size_t column) {
  std::ifstream file(path);
  std::vector<sensors::Beam> tilts;
  std::string line;
  for (std::getline(file, line); std::getline(file, line);) {
    std::istringstream words(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(words, cell, ',');) {
      cells.push_back(cell);
    }
    if (cells.size() > column + 1 && !cells[column].empty() && !cells[column + 1].empty()) {
      tilts.push_back({radians(std::stod(cells[column])), 0.01 * std::stod(cells[column + 1])});
    }
  }
  return tilts;
}

/// The cone of a card's tilts; the paper's figure is of things at a distance.
BeamWidth opening_before(const std::string& path, const Card& card) {
  const auto opening = beam_width_by_tilt(tilts_of(path, card.column), {card.range_m, 0.05, 0.0});
  if (!opening) {
    throw std::runtime_error("no edge in the tilts of " + std::string(card.name));
  }
  std::cout << "HC-SR04, card " << card.name << ": " << degrees(opening->beam_width_rad) << " ("
            << degrees(opening->low_rad) << " to " << degrees(opening->high_rad) << ") degrees\n";
  return *opening;
}

TEST(ConeAngle, OfTheHcSr04IsThePapersAt10CmAndWiderBeforeNearCards) {
  const auto path = tests::real_data("hcsr04_incidence_univpm/Misure_prove.csv");
  ECHOMAP_SKIP_WITHOUT(path);
  for (const Card& card : kCards) {
    const BeamWidth opening = opening_before(path.string(), card);
    if (card.range_m >= 0.1) {
      expect_within_paper(opening.low_rad);
      expect_within_paper(opening.high_rad);
    } else if (card.range_m > 0.055) {
      expect_within_paper(opening.beam_width_rad);
    } else {
      EXPECT_GT(degrees(opening.low_rad), kPaperDeg + kPaperBoundDeg);
    }
  }
}

}  // namespace
}  // namespace echomap::papers

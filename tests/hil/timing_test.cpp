// SPDX-License-Identifier: MIT
#include "tests/hil/measure/timing.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

void print(const TimingFigures& figures) {
  std::printf("timing: interrupts %.1f %%, program %.1f %%, tick within %.2f us\n",
              100.0 * figures.interrupt_share,
              100.0 * figures.program_share,
              figures.tick_jitter_us);
  std::printf("timing: %.0f B/s in, %.0f B/s out\n",
              figures.load.host_bytes_per_s,
              figures.load.robot_bytes_per_s);
}

/// The page with the board's table of interrupts.
std::string page_of(const std::string& image) {
  return image == "echomap-mega" ? "docs/hardware/mega.md" : "docs/firmware_timing.md";
}

/// The first three numbers of a row of that table.
struct DocumentedCost {
  double least = 0.0;
  double mean = 0.0;
  double most = 0.0;
};

/// Rows "| NAME | least | mean | most | ..", by name.
std::map<std::string, DocumentedCost> documented_costs(const std::string& page_name) {
  std::ifstream page(std::string(ECHOMAP_SOURCE_DIR) + '/' + page_name);
  std::map<std::string, DocumentedCost> costs;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| ")) {
      continue;
    }
    const std::string name = line.substr(2, line.find(" |", 2) - 2);
    DocumentedCost cost;
    char bar = 0;
    std::istringstream rest(line.substr(2 + name.size()));
    if (rest >> bar >> cost.least >> bar >> cost.mean >> bar >> cost.most >> bar) {
      costs[name] = cost;
    }
  }
  return costs;
}

class Interrupts : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Boards, Interrupts, every_board(), image_label);

TEST_P(Interrupts, CostWhatTheirTableSays) {
  const TimingFigures figures =
      measure_timing(release_image(GetParam()), {.edges_per_s = 40'000, .every_sensor = true}, 5.0);
  const std::string page = page_of(GetParam());
  const auto documented = documented_costs(page);
  for (const auto& [name, cost] : figures.interrupts) {
    std::printf("| %s | %u | %.1f | %u |\n", name.c_str(), cost.least, cost.mean(), cost.most);
    ASSERT_TRUE(documented.contains(name)) << page << " has no row for " << name;
    const DocumentedCost& row = documented.at(name);
    const auto expect_near = [&](double measured, double told) {
      EXPECT_NEAR(measured, told, 0.05 * told) << page << " is stale: " << name;
    };
    expect_near(cost.least, row.least);
    expect_near(cost.mean(), row.mean);
    expect_near(cost.most, row.most);
  }
  EXPECT_EQ(figures.interrupts.size(), documented.size());
}

/// An echo and an edge of each wheel, one right after the other, take 229 cycles, and a lock of the
/// program may stand before them. Whether they come just before a tick is chance: edges, bytes and
/// frames are in step with the ticks here, so an image meets them all the time or never.
constexpr double kMaxTickJitterUs = 18.0;

class Timing : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Boards, Timing, every_board(), image_label);

TEST_P(Timing, UsualLoadLeavesTwoThirdsOfTheChip) {
  const TimingFigures figures = measure_timing(release_image(GetParam()), usual_load(20'000), 10.0);
  print(figures);
  EXPECT_LE(100.0 * figures.busy_share(), 35.0);
  EXPECT_GT(100.0 * figures.busy_share(), 10.0) << "the meter does not measure";
  EXPECT_LE(figures.tick_jitter_us, kMaxTickJitterUs);
}

/// A hundred Gyro messages a second, and on the Mega fourteen pins.
TEST_P(Timing, EverySensorLeavesHalfOfTheChip) {
  Load load = usual_load(20'000);
  load.every_sensor = true;
  const TimingFigures figures = measure_timing(release_image(GetParam()), load, 10.0);
  print(figures);
  EXPECT_LE(100.0 * figures.busy_share(), 45.0);
  EXPECT_LE(figures.tick_jitter_us, kMaxTickJitterUs);
}

TEST_P(Timing, TickHoldsOnAFullLine) {
  for (const double edges_per_s : {20'000.0, 40'000.0}) {
    const TimingFigures figures =
        measure_timing(release_image(GetParam()), {.edges_per_s = edges_per_s}, 20.0);
    print(figures);
    EXPECT_LE(figures.tick_jitter_us, kMaxTickJitterUs);
    EXPECT_LE(100.0 * figures.busy_share(), 80.0);
  }
}

class Control : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Boards, Control, every_board(), image_label);

/// At rates beside the nominal one, too: where bytes of the line fall is a matter of phase.
TEST_P(Control, DutyIsMadeOfCountsOfTheLastFiftyMicroseconds) {
  for (const double edges_per_s : {39'000.0, 39'700.0, 40'000.0, 40'300.0, 41'000.0}) {
    const ControlFigures figures =
        measure_control(release_image(GetParam()), {.edges_per_s = edges_per_s}, 4.0);
    std::printf("control: %.0f Hz, sample to PWM %.1f us, %.1f us at most\n",
                figures.duties_per_s,
                figures.mean_us,
                figures.max_us);
    EXPECT_NEAR(figures.duties_per_s, 250.0, 1.0);
    EXPECT_LE(figures.max_us, 50.0);
    EXPECT_GT(figures.mean_us, 5.0) << "the delay is not measured";
  }
}

}  // namespace
}  // namespace echomap::tests

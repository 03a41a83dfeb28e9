// SPDX-License-Identifier: MIT
#include "host/source_search/nuisance_integral.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace echomap::source_search {
namespace {

NuisanceNodes nodes_to(double max_strength, std::size_t count) {
  NuisanceNodes nodes;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    nodes.strengths.push_back(static_cast<float>(std::pow(max_strength, share)));
  }
  nodes.backgrounds = {1.0F};
  nodes.shieldings = {{}};
  return nodes;
}

/// Log-likelihood of `pulses` where a strength of 1 gives `per_strength`.
double log_of_pulses(double pulses, double per_strength, double strength) {
  const double mean = per_strength * strength;
  return pulses * std::log(mean) - mean - std::lgamma(pulses + 1.0);
}

/// The integral by sums in tiny steps.
double fine_integral(double pulses, double per_strength, double max_strength) {
  constexpr int kSteps = 20000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double strength = std::pow(max_strength, (i + 0.5) / kSteps);
    sum += std::exp(log_of_pulses(pulses, per_strength, strength)) / kSteps;
  }
  return sum;
}

double integral_by_nodes(double pulses, double per_strength, std::size_t cuts) {
  const NuisanceNodes nodes = nodes_to(50.0, 12);
  std::vector<float> rows;
  for (const float strength : nodes.strengths) {
    const double value = log_of_pulses(pulses, per_strength, static_cast<double>(strength));
    rows.insert(rows.end(), kLanes, static_cast<float>(value));
  }
  const auto group = NuisanceIntegral(nodes, cuts, {1.0F}).group(rows.data());
  return static_cast<double>(group.sum[3]) * std::exp(static_cast<double>(group.max[3]));
}

TEST(NuisanceIntegral, MassesSumToOne) {
  const NuisanceIntegral integral(nodes_to(50.0, 10), 3, {1.0F});
  double sum = 0.0;
  for (const auto& step : integral.steps()) {
    sum += static_cast<double>(step.mass);
  }
  EXPECT_NEAR(sum, 1.0, 1e-5);
}

TEST(NuisanceIntegral, FindsANarrowPeakBetweenNodes) {
  for (const double per_strength : {20.0, 22.0, 25.0, 27.0, 30.0}) {
    const double expected = fine_integral(300.0, per_strength, 50.0);
    EXPECT_NEAR(integral_by_nodes(300.0, per_strength, 8) / expected, 1.0, 0.2) << per_strength;
  }
}

TEST(NuisanceIntegral, FewCutsDoForFewPulses) {
  for (const double per_strength : {0.3, 0.7, 2.0}) {
    const double expected = fine_integral(4.0, per_strength, 50.0);
    EXPECT_NEAR(integral_by_nodes(4.0, per_strength, 1) / expected, 1.0, 0.03) << per_strength;
  }
}

}  // namespace
}  // namespace echomap::source_search

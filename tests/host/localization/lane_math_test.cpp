// SPDX-License-Identifier: MIT
#include "host/localization/lane_math.hpp"

#include <cmath>
#include <cstdint>
#include <tuple>

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

TEST(LaneMath, KnowsSineAndCosineToSinglePrecision) {
  for (double angle_rad = -50.0; angle_rad < 50.0; angle_rad += 0.0137) {
    const SinCos ours = sin_cos(static_cast<float>(angle_rad));
    const double angle = static_cast<double>(static_cast<float>(angle_rad));
    ASSERT_NEAR(static_cast<double>(ours.sin), std::sin(angle), 2e-6) << angle_rad;
    ASSERT_NEAR(static_cast<double>(ours.cos), std::cos(angle), 2e-6) << angle_rad;
  }
}

TEST(LaneMath, WrapsToTheSameDirection) {
  for (double angle_rad = -50.0; angle_rad < 50.0; angle_rad += 0.0137) {
    const auto ours = static_cast<double>(wrapped(static_cast<float>(angle_rad)));
    ASSERT_LE(std::abs(ours), 3.14160) << angle_rad;
    ASSERT_NEAR(std::remainder(ours - angle_rad, 6.283185307179586), 0.0, 1e-5) << angle_rad;
  }
}

TEST(LaneMath, KnowsExponentialsAndLogarithms) {
  for (double power = -80.0; power <= 0.0; power += 0.0173) {
    const auto exact = std::exp(static_cast<double>(static_cast<float>(power)));
    ASSERT_NEAR(static_cast<double>(exp_of_negative(static_cast<float>(power))) / exact, 1.0, 5e-6)
        << power;
  }
  EXPECT_EQ(exp_of_negative(-1000.0F), 0.0F);
  EXPECT_EQ(exp_of_negative(0.0F), 1.0F);
  for (double number = 1e-8; number < 1e8; number *= 1.0173) {
    const auto exact = std::log(static_cast<double>(static_cast<float>(number)));
    ASSERT_NEAR(static_cast<double>(log_of(static_cast<float>(number))),
                exact,
                2e-6 * std::max(1.0, std::abs(exact)))
        << number;
  }
}

TEST(LaneMath, DrawsEvenNumbers) {
  constexpr std::uint32_t kCount = 200'000;
  double sum = 0.0;
  double squares = 0.0;
  double products = 0.0;
  double last = 0.5;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const auto number = static_cast<double>(random_bits({17, 4}, i)) * 0x1p-32;
    ASSERT_GE(number, 0.0);
    ASSERT_LT(number, 1.0);
    sum += number;
    squares += number * number;
    products += (number - 0.5) * (last - 0.5);
    last = number;
  }
  EXPECT_NEAR(sum / kCount, 0.5, 0.003);
  EXPECT_NEAR(squares / kCount, 1.0 / 3.0, 0.003);
  EXPECT_NEAR(products / kCount, 0.0, 0.001);
}

TEST(LaneMath, DrawsNormalNumbersThatAreIndependent) {
  constexpr std::uint32_t kCount = 200'000;
  NormalPair mean, square, fourth;
  float product = 0.0F;
  float next_product = 0.0F;
  float last = 0.0F;
  int beyond_two = 0;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const NormalPair pair = normal_pair(random_bits({5, 6}, i));
    const auto add = [](float number, float& one, float& two, float& four) {
      one += number / kCount;
      two += number * number / kCount;
      four += number * number * number * number / kCount;
    };
    add(pair.first, mean.first, square.first, fourth.first);
    add(pair.second, mean.second, square.second, fourth.second);
    product += pair.first * pair.second / kCount;
    next_product += last * pair.first / kCount;
    last = pair.second;
    beyond_two += std::abs(pair.first) > 2.0F ? 1 : 0;
  }
  for (const auto& [one, two, four] : {std::tuple{mean.first, square.first, fourth.first},
                                       {mean.second, square.second, fourth.second}}) {
    EXPECT_NEAR(one, 0.0F, 0.01F);
    EXPECT_NEAR(two, 1.0F, 0.015F);
    EXPECT_NEAR(four, 3.0F, 0.1F);
  }
  EXPECT_NEAR(product, 0.0F, 0.01F);
  EXPECT_NEAR(next_product, 0.0F, 0.01F);
  EXPECT_NEAR(beyond_two / static_cast<double>(kCount), 0.0455, 0.002);
}

TEST(LaneMath, DrawsFiniteNormalNumbersOfAnyBits) {
  for (const std::uint32_t bits : {0U, 0xFFFFFFFFU, 0x3FFFU, 0xFFFFC000U, 0x2000U, 0x1FFFU}) {
    const NormalPair pair = normal_pair(bits);
    ASSERT_LE(std::hypot(pair.first, pair.second), 5.2F) << bits;
  }
}

}  // namespace
}  // namespace echomap::localization

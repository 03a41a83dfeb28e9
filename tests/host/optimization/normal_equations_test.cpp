// SPDX-License-Identifier: MIT
#include "host/optimization/normal_equations.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "host/optimization/gauss_newton.hpp"

namespace echomap::optimization {
namespace {

using Row = Eigen::RowVector2d;

TEST(NormalEquations, MeetMeasurementsThatAgree) {
  NormalEquations<2> equations;
  equations.add(-3.0, Row(1.0, 0.0), 4.0);
  equations.add(-5.0, Row(1.0, 1.0), 0.5);
  EXPECT_LT((equations.solve().value() - Eigen::Vector2d(3.0, 2.0)).norm(), 1e-12);
}

TEST(NormalEquations, WeighMeasurementsThatDisagreeByTheirInformation) {
  NormalEquations<1> equations;
  using One = Eigen::Matrix<double, 1, 1>;
  equations.add(-1.0, One(1.0), 3.0);
  equations.add_prior(One(-5.0), One(1.0));
  EXPECT_NEAR(equations.solve().value()[0], 2.0, 1e-12);
}

TEST(NormalEquations, AResidualOfTwoNumbersIsTwoOfOneWhereTheyAreIndependent) {
  NormalEquations<2> together;
  NormalEquations<2> apart;
  Eigen::Matrix2d jacobian;
  jacobian << 1.0, 2.0, -0.5, 0.3;
  const Eigen::Vector2d residual(0.7, -0.2);
  const Eigen::Vector2d information(5.0, 2.0);
  together.add<2>(residual, jacobian, information.asDiagonal());
  for (const int i : {0, 1}) {
    apart.add(residual[i], jacobian.row(i), information[i]);
  }
  EXPECT_LT((together.information() - apart.information()).norm(), 1e-12);
  EXPECT_LT((together.gradient() - apart.gradient()).norm(), 1e-12);
}

TEST(NormalEquations, CountOthersByAWeight) {
  NormalEquations<2> once;
  once.add(1.0, Row(1.0, 2.0), 3.0);
  NormalEquations<2> sum;
  sum.add(once, 0.5);
  EXPECT_EQ(sum.information(), Eigen::Matrix2d(0.5 * once.information()));
  EXPECT_EQ(sum.gradient(), Eigen::Vector2d(0.5 * once.gradient()));
}

TEST(NormalEquations, HaveNoStepWhereAResidualIsNotFinite) {
  NormalEquations<2> equations;
  equations.add(std::numeric_limits<double>::quiet_NaN(), Row(1.0, 1.0), 1.0);
  EXPECT_FALSE(equations.solve());
}

// --- the iterations

/// The residual x^2 - 2 of one unknown.
struct RootOfTwo {
  double x = 1.0;
  int steps = 0;

  NormalEquations<1> linearize() const {
    NormalEquations<1> equations;
    equations.add(x * x - 2.0, Eigen::Matrix<double, 1, 1>(2.0 * x), 1.0);
    return equations;
  }
  bool apply(const Eigen::Matrix<double, 1, 1>& step) {
    x += step[0];
    ++steps;
    return std::abs(step[0]) < 1e-6;
  }
  bool solve(int max_iterations) {
    return gauss_newton(
        max_iterations, [&] { return linearize(); }, [&](const auto& step) { return apply(step); });
  }
};

TEST(GaussNewton, EndsWhereTheEstimateHasConverged) {
  RootOfTwo root;
  EXPECT_TRUE(root.solve(50));
  EXPECT_NEAR(root.x, std::sqrt(2.0), 1e-12);
  EXPECT_LT(root.steps, 10);
}

TEST(GaussNewton, TakesNoMoreThanItsIterations) {
  RootOfTwo root;
  EXPECT_TRUE(root.solve(2));
  EXPECT_EQ(root.steps, 2);
}

TEST(GaussNewton, StaysWhereNoStepIsDetermined) {
  RootOfTwo root{std::numeric_limits<double>::infinity()};
  EXPECT_FALSE(root.solve(5));
  EXPECT_EQ(root.steps, 0);
}

}  // namespace
}  // namespace echomap::optimization

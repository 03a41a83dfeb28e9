// SPDX-License-Identifier: MIT
#include "host/optimization/block_equations.hpp"

#include <cmath>
#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace echomap::optimization {
namespace {

template <int kRows, int kColumns>
Eigen::Matrix<double, kRows, kColumns> random_matrix(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  Eigen::Matrix<double, kRows, kColumns> matrix;
  for (double& value : matrix.reshaped()) {
    value = any(random);
  }
  return matrix;
}

Eigen::Matrix2d random_information(std::mt19937& random) {
  const Eigen::Matrix2d root = random_matrix<2, 2>(random);
  return root * root.transpose() + Eigen::Matrix2d::Identity();
}

/// A fixed block, one of three unknowns and one of two, joined by factors, and the same equations
/// as dense matrices of the five free unknowns.
struct SmallProblem {
  BlockEquations blocks;
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(5, 5);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(5);

  explicit SmallProblem(std::mt19937& random) {
    blocks.add_fixed_block();
    blocks.add_block(3);
    blocks.add_block(2);
    for (int i = 0; i < 6; ++i) {
      const Eigen::Vector2d residual = random_matrix<2, 1>(random);
      const Eigen::Matrix2d weight = random_information(random);
      const auto by_fixed = random_matrix<2, 3>(random);
      const auto by_three = random_matrix<2, 3>(random);
      const auto by_two = random_matrix<2, 2>(random);
      blocks.add<2, 2, 3, 3>(residual, weight, {2, by_two}, {0, by_fixed}, {1, by_three});
      Eigen::Matrix<double, 2, 5> jacobian;
      jacobian << by_three, by_two;
      information += jacobian.transpose() * weight * jacobian;
      gradient += jacobian.transpose() * weight * residual;
    }
  }
};

TEST(BlockEquations, SayWhatDenseEquationsSay) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 20; ++trial) {
    const SmallProblem problem(random);
    const BlockSolution solution = problem.blocks.solve(2).value();
    const Eigen::VectorXd step = -problem.information.inverse() * problem.gradient;
    EXPECT_LT((solution.step_of<3>(1) - step.head<3>()).norm(), 1e-9);
    EXPECT_LT((solution.step_of<2>(2) - step.tail<2>()).norm(), 1e-9);
    EXPECT_LT((solution.covariance - problem.information.inverse().bottomRightCorner(2, 2)).norm(),
              1e-9);
    EXPECT_NEAR(solution.log_determinant, std::log(problem.information.determinant()), 1e-9);
  }
}

TEST(BlockEquations, AFixedBlockDoesNotMove) {
  std::mt19937 random(5);
  const SmallProblem problem(random);
  EXPECT_EQ(problem.blocks.solve().value().step_of<3>(0), Eigen::Vector3d::Zero());
}

TEST(BlockEquations, AFactorMayJoinABlockWithItself) {
  BlockEquations equations;
  equations.add_block(1);
  using One = Eigen::Matrix<double, 1, 1>;
  equations.add<1, 1>(-6.0, 1.0, {0, One(1.0)}, {0, One(2.0)});
  EXPECT_NEAR(equations.solve().value().step_of<1>(0)[0], 2.0, 1e-12);
}

TEST(BlockEquations, SayNothingWhereABlockHangsOnNothing) {
  BlockEquations equations;
  equations.add_block(2);
  equations.add_block(2);
  equations.add<2, 2>(
      Eigen::Vector2d(1.0, 1.0), Eigen::Matrix2d::Identity(), {0, Eigen::Matrix2d::Identity()});
  EXPECT_FALSE(equations.solve());
}

/// A chain of three numbers whose differences are measured: it may be shifted as a whole.
BlockEquations free_chain() {
  BlockEquations equations;
  using One = Eigen::Matrix<double, 1, 1>;
  for (int i = 0; i < 3; ++i) {
    equations.add_block(1);
  }
  for (const std::size_t i : {0U, 1U}) {
    equations.add<1, 1>(-1.0, 1.0, {i, One(-1.0)}, {i + 1, One(1.0)});
  }
  return equations;
}

TEST(BlockEquations, SayNothingOfAGraphThatMayMoveAsAWhole) {
  EXPECT_FALSE(free_chain().solve()) << "though a shift of any size solves the equations";
}

TEST(BlockEquations, DetermineThatGraphOnceAPriorHoldsIt) {
  BlockEquations equations = free_chain();
  equations.add<1>(0.0, 1.0, {0, Eigen::Matrix<double, 1, 1>(1.0)});
  const BlockSolution solution = equations.solve().value();
  EXPECT_NEAR(solution.step_of<1>(0)[0], 0.0, 1e-12);
  EXPECT_NEAR(solution.step_of<1>(2)[0], 2.0, 1e-12);
}

}  // namespace
}  // namespace echomap::optimization

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace echomap::optimization {

/// Holds the derivatives of a residual of `kRows` numbers by the unknowns of one block.
template <int kRows, int kSize>
struct BlockJacobian {
  std::size_t block = 0;
  Eigen::Matrix<double, kRows, kSize> jacobian = Eigen::Matrix<double, kRows, kSize>::Zero();
};

/// Says which rows of the equations belong to a block.
struct BlockRows {
  Eigen::Index first = 0;
  Eigen::Index count = 0;  ///< 0 for a fixed block.
};

/// Holds what BlockEquations determine.
struct BlockSolution {
  Eigen::VectorXd step;          ///< Of all free blocks.
  double log_determinant = 0.0;  ///< Of the information matrix.
  Eigen::MatrixXd covariance;    ///< Marginal, of the block that was asked for.
  std::vector<BlockRows> blocks;

  /// Returns the step of one block of `kSize` unknowns; it is zero for a fixed one.
  template <int kSize>
  Eigen::Matrix<double, kSize, 1> step_of(std::size_t block) const {
    const BlockRows& rows = blocks[block];
    return rows.count == 0
               ? Eigen::Matrix<double, kSize, 1>(Eigen::Matrix<double, kSize, 1>::Zero())
               : Eigen::Matrix<double, kSize, 1>(step.segment<kSize>(rows.first));
  }
};

/// Collects the normal equations of weighted least squares over many blocks of unknowns, as poses
/// and landmarks. They are sparse, since each factor joins few of them (Grisetti et al. 2010,
/// section IV; Kuemmerle et al. 2011). Fixed blocks leave the equations.
class BlockEquations {
 public:
  /// Adds a block of unknowns and returns its number; they count from 0.
  std::size_t add_block(Eigen::Index size);
  std::size_t add_fixed_block() { return add_block(0); }

  /// Adds a factor: a residual with its information matrix and its derivatives by the blocks that
  /// it joins.
  template <int kRows, int... kSizes>
  void add(const Eigen::Matrix<double, kRows, 1>& residual,
           const Eigen::Matrix<double, kRows, kRows>& information,
           const BlockJacobian<kRows, kSizes>&... by) {
    const auto add_rows = [&](const auto& row) {
      if (blocks_[row.block].count == 0) {
        return;
      }
      const auto weighted = (row.jacobian.transpose() * information).eval();
      gradient_.segment(blocks_[row.block].first, weighted.rows()) += weighted * residual;
      (add_information(row.block, by.block, (weighted * by.jacobian).eval()), ...);
    };
    (add_rows(by), ...);
  }

  /// Does the same for a residual of one number, weighted by the inverse of its variance.
  template <int... kSizes>
  void add(double residual, double information, const BlockJacobian<1, kSizes>&... by) {
    using Scalar = Eigen::Matrix<double, 1, 1>;
    add<1, kSizes...>(Scalar(residual), Scalar(information), by...);
  }

  /// Returns the step of Gauss and Newton by a sparse Cholesky factorisation, on request with the
  /// marginal covariance of one block that is not fixed. It is empty unless the information matrix
  /// is positive definite: where a block, or the whole graph, may move without an error, even if
  /// some step would solve the equations. The caller then fixes a block, adds a prior, or leaves
  /// its estimate as it is.
  std::optional<BlockSolution> solve(std::optional<std::size_t> covariance_of = {}) const;

 private:
  /// Only the lower half is stored.
  template <class Block>
  void add_information(std::size_t row_block, std::size_t column_block, const Block& block) {
    const Eigen::Index row = blocks_[row_block].first;
    const Eigen::Index column = blocks_[column_block].first;
    if (blocks_[column_block].count == 0 || row < column) {
      return;
    }
    for (Eigen::Index i = 0; i < block.rows(); ++i) {
      for (Eigen::Index k = 0; k < block.cols() && column + k <= row + i; ++k) {
        entries_.emplace_back(row + i, column + k, block(i, k));
      }
    }
  }

  std::vector<BlockRows> blocks_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd gradient_;
};

}  // namespace echomap::optimization

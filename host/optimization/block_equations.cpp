// SPDX-License-Identifier: MIT
#include "host/optimization/block_equations.hpp"

#include <Eigen/SparseCholesky>

namespace echomap::optimization {

std::size_t BlockEquations::add_block(Eigen::Index size) {
  blocks_.push_back({gradient_.size(), size});
  gradient_.conservativeResize(gradient_.size() + size);
  gradient_.tail(size).setZero();
  return blocks_.size() - 1;
}

std::optional<BlockSolution> BlockEquations::solve(std::optional<std::size_t> covariance_of) const {
  const Eigen::Index size = gradient_.size();
  Eigen::SparseMatrix<double> information(size, size);
  information.setFromTriplets(entries_.begin(), entries_.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(information);
  if (factors.info() != Eigen::Success || !(factors.vectorD().array() > 0.0).all()) {
    return std::nullopt;
  }
  const BlockRows asked = covariance_of ? blocks_[*covariance_of] : BlockRows{};
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(size, 1 + asked.count);
  right.col(0) = -gradient_;
  right.block(asked.first, 1, asked.count, asked.count).setIdentity();
  const Eigen::MatrixXd solved = factors.solve(right);
  if (!solved.allFinite()) {
    return std::nullopt;
  }
  return BlockSolution{solved.col(0),
                       factors.vectorD().array().log().sum(),
                       solved.block(asked.first, 1, asked.count, asked.count),
                       blocks_};
}

}  // namespace echomap::optimization

// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace echomap::slam {

/// A symmetric matrix that grows and shrinks by rows and columns. Only the lower triangle is kept
/// up to date, and room for more is made in advance, so that a new landmark copies nothing.
class GrowingCovariance {
 public:
  Eigen::Index size() const { return size_; }

  double at(Eigen::Index row, Eigen::Index column) const {
    return row >= column ? lower_(row, column) : lower_(column, row);
  }
  /// Any block of the whole matrix.
  template <int kRows, int kColumns>
  Eigen::Matrix<double, kRows, kColumns> block(Eigen::Index row, Eigen::Index column) const {
    Eigen::Matrix<double, kRows, kColumns> block;
    for (Eigen::Index i = 0; i < kRows; ++i) {
      for (Eigen::Index j = 0; j < kColumns; ++j) {
        block(i, j) = at(row + i, column + j);
      }
    }
    return block;
  }
  /// Whole columns from `first` on.
  template <int kColumns>
  Eigen::Matrix<double, Eigen::Dynamic, kColumns> columns(Eigen::Index first) const {
    Eigen::Matrix<double, Eigen::Dynamic, kColumns> columns(size_, kColumns);
    columns.topRows(first) = lower_.block(first, 0, kColumns, first).transpose();
    columns.middleRows(first, kColumns) = block<kColumns, kColumns>(first, first);
    const Eigen::Index below = first + kColumns;
    columns.bottomRows(size_ - below) = lower_.block(below, first, size_ - below, kColumns);
    return columns;
  }
  /// Replaces whole columns from `first` on, and the same rows.
  void set_columns(Eigen::Index first, const Eigen::MatrixXd& columns);
  /// Adds left * right^T, which must be symmetric.
  void add_product(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right);
  /// Appends rows and columns: `cross` holds them up to the old size, `corner` beyond.
  void append(const Eigen::MatrixXd& cross, const Eigen::MatrixXd& corner);
  /// Takes rows and columns out.
  void erase(Eigen::Index first, Eigen::Index count);
  /// All of it, for those who look at it.
  Eigen::MatrixXd whole() const;

 private:
  Eigen::Index size_ = 0;
  Eigen::MatrixXd lower_;
};

}  // namespace echomap::slam

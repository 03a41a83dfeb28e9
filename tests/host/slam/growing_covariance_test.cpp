// SPDX-License-Identifier: MIT
#include "host/slam/growing_covariance.hpp"

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

/// A symmetric matrix with all its numbers different.
Eigen::MatrixXd numbered(Eigen::Index size) {
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) {
      matrix(i, j) = static_cast<double>(10 * std::min(i, j) + std::max(i, j));
    }
  }
  return matrix;
}

/// The same, grown by steps of 1 or 2.
GrowingCovariance grown(Eigen::Index size) {
  const Eigen::MatrixXd matrix = numbered(size);
  GrowingCovariance covariance;
  for (Eigen::Index at = 0; at < size;) {
    const Eigen::Index count = std::min<Eigen::Index>(size - at, 1 + at % 2);
    covariance.append(matrix.block(at, 0, count, at), matrix.block(at, at, count, count));
    at += count;
  }
  return covariance;
}

TEST(GrowingCovariance, IsWhatWasAppended) {
  EXPECT_EQ(grown(9).whole(), numbered(9));
  EXPECT_EQ(grown(200).whole(), numbered(200)) << "across its room";
}

TEST(GrowingCovariance, AnswersBlocksAndColumnsOfTheWholeMatrix) {
  const GrowingCovariance covariance = grown(9);
  const Eigen::MatrixXd whole = numbered(9);

  EXPECT_EQ((covariance.block<2, 3>(1, 5)), (whole.block<2, 3>(1, 5)));
  EXPECT_EQ((covariance.block<3, 3>(4, 4)), (whole.block<3, 3>(4, 4)));
  EXPECT_EQ(covariance.columns<3>(4), whole.middleCols<3>(4));
  EXPECT_EQ(covariance.columns<2>(0), whole.leftCols<2>());
}

TEST(GrowingCovariance, KeepsRowsAndColumnsTheSame) {
  GrowingCovariance covariance = grown(7);
  Eigen::MatrixXd whole = numbered(7);
  const Eigen::MatrixXd columns = 3.0 * whole.middleCols<2>(3);
  covariance.set_columns(3, columns);

  whole.middleCols<2>(3) = columns;
  whole.middleRows<2>(3) = columns.transpose();
  EXPECT_EQ(covariance.whole(), whole);
}

TEST(GrowingCovariance, AddsASymmetricProduct) {
  GrowingCovariance covariance = grown(6);
  const Eigen::MatrixXd left = numbered(6).leftCols<2>();
  covariance.add_product(left, -2.0 * left);

  EXPECT_TRUE(covariance.whole().isApprox(numbered(6) - 2.0 * left * left.transpose()));
}

TEST(GrowingCovariance, ClosesUpBehindWhatIsErased) {
  for (const Eigen::Index first : {0, 3, 7}) {
    GrowingCovariance covariance = grown(9);
    covariance.erase(first, 2);

    Eigen::MatrixXd kept(7, 7);
    for (Eigen::Index i = 0; i < 7; ++i) {
      for (Eigen::Index j = 0; j < 7; ++j) {
        kept(i, j) = numbered(9)(i < first ? i : i + 2, j < first ? j : j + 2);
      }
    }
    EXPECT_EQ(covariance.whole(), kept) << "from " << first;
  }
}

}  // namespace
}  // namespace echomap::slam

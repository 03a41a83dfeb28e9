// SPDX-License-Identifier: MIT
#include "host/slam/growing_covariance.hpp"

#include <algorithm>

namespace echomap::slam {

namespace {

constexpr Eigen::Index kMinRoom = 64;

}  // namespace

void GrowingCovariance::set_columns(Eigen::Index first, const Eigen::MatrixXd& columns) {
  const Eigen::Index count = columns.cols();
  lower_.block(first, 0, count, first) = columns.topRows(first).transpose();
  lower_.block(first, first, size_ - first, count) = columns.bottomRows(size_ - first);
}

void GrowingCovariance::add_product(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right) {
  lower_.topLeftCorner(size_, size_).triangularView<Eigen::Lower>() += left * right.transpose();
}

void GrowingCovariance::append(const Eigen::MatrixXd& cross, const Eigen::MatrixXd& corner) {
  const Eigen::Index after = size_ + corner.rows();
  if (after > lower_.rows()) {
    const Eigen::Index room = std::max(kMinRoom, 2 * after);
    lower_.conservativeResize(room, room);
  }
  lower_.block(size_, 0, corner.rows(), size_) = cross;
  lower_.block(size_, size_, corner.rows(), corner.rows()) = corner;
  size_ = after;
}

void GrowingCovariance::erase(Eigen::Index first, Eigen::Index count) {
  const Eigen::Index behind = size_ - first - count;
  for (Eigen::Index column = 0; column < size_; ++column) {
    // Upwards and to the left: no number is read after it has been written over.
    const Eigen::Index to = column < first ? column : column - count;
    if (column >= first && column < first + count) {
      continue;
    }
    for (Eigen::Index row = 0; row < behind; ++row) {
      lower_(first + row, to) = lower_(first + count + row, column);
    }
  }
  size_ -= count;
}

Eigen::MatrixXd GrowingCovariance::whole() const {
  return lower_.topLeftCorner(size_, size_).selfadjointView<Eigen::Lower>();
}

}  // namespace echomap::slam

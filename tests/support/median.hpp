// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

namespace echomap::tests {

/// The middle of the sorted values, or the mean of the two middle ones. `values` is not empty.
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace echomap::tests

// SPDX-License-Identifier: MIT
#include "host/files/nearest_word.hpp"

#include <algorithm>

namespace echomap::files {

std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::vector<std::size_t>> cost(from.size() + 1,
                                             std::vector<std::size_t>(to.size() + 1));
  for (std::size_t i = 0; i <= from.size(); ++i) {
    for (std::size_t j = 0; j <= to.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = i + j;
        continue;
      }
      const std::size_t replace = cost[i - 1][j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, replace});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1]) {
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
      }
    }
  }
  return cost[from.size()][to.size()];
}

std::string suggestion(std::string_view word, const std::vector<std::string>& valid) {
  if (valid.empty()) {
    return {};
  }
  const auto nearest =
      std::min_element(valid.begin(), valid.end(), [&](const auto& a, const auto& b) {
        return edit_distance(word, a) < edit_distance(word, b);
      });
  if (edit_distance(word, *nearest) <= std::max<std::size_t>(2, word.size() / 2)) {
    return "; did you mean '" + *nearest + "'?";
  }
  std::string list;
  for (const auto& candidate : valid) {
    list += (list.empty() ? "" : ", ") + candidate;
  }
  return "; valid here: " + list;
}

}  // namespace echomap::files

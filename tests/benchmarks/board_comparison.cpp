// SPDX-License-Identifier: MIT
#include "tests/benchmarks/board_comparison.hpp"

#include <algorithm>
#include <stdexcept>

namespace echomap::bench {
namespace {

const Figure* find_figure(const std::vector<Figure>& figures, const std::string& name) {
  const auto found = std::find_if(
      figures.begin(), figures.end(), [&](const Figure& figure) { return figure.name == name; });
  return found != figures.end() ? &*found : nullptr;
}

/// Most of the sorted `values` that lie within kMaxFreeIouSpread.
std::size_t largest_group(const std::vector<double>& values) {
  constexpr double kRounding = 1e-9;
  std::size_t largest = 0;
  for (auto first = values.begin(); first != values.end(); ++first) {
    const auto last = std::upper_bound(first, values.end(), *first + kMaxFreeIouSpread + kRounding);
    largest = std::max(largest, static_cast<std::size_t>(last - first));
  }
  return largest;
}

}  // namespace

double value_of(const std::vector<Figure>& figures, const std::string& name) {
  const Figure* figure = find_figure(figures, name);
  if (figure == nullptr) {
    throw std::invalid_argument("no figure '" + name + "'");
  }
  return figure->value;
}

std::vector<Figure> compare_boards(const std::vector<BoardRuns>& boards) {
  std::vector<Figure> all;
  std::vector<double> run;
  std::vector<double> passing;
  for (const BoardRuns& board : boards) {
    for (Figure figure : board.figures) {
      figure.name = board.board + "_" + figure.name;
      all.push_back(figure);
    }
    if (const Figure* free_iou = find_figure(board.figures, "free_iou")) {
      run.push_back(free_iou->value);
      if (board.passes) {
        passing.push_back(free_iou->value);
      }
    }
  }
  std::sort(passing.begin(), passing.end());
  if (!run.empty()) {
    const auto [least, most] = std::minmax_element(run.begin(), run.end());
    all.push_back({"free_iou_spread", *most - *least, "", run.size(), {}});
  }
  all.push_back(
      {"boards_passing", static_cast<double>(largest_group(passing)), "", boards.size(), {}});
  return all;
}

}  // namespace echomap::bench

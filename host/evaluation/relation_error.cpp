// SPDX-License-Identifier: MIT
#include "host/evaluation/relation_error.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "host/datasets/line_reader.hpp"
#include "host/exports/number_table.hpp"

namespace echomap::evaluation {
namespace {

constexpr exports::NumberTableFormat kFormat{"", ' ', 5};
constexpr double kMaxRecords = 4294967296.0;

bool is_index(double value) {
  return value >= 0.0 && value < kMaxRecords && value == std::floor(value);
}

/// Mean and standard deviation of what is added.
class Spread {
 public:
  void add(double value) {
    ++count_;
    sum_ += value;
    sum_of_squares_ += value * value;
  }
  double mean() const { return sum_ / count_; }
  double sd() const { return std::sqrt(std::max(0.0, sum_of_squares_ / count_ - mean() * mean())); }

 private:
  double count_ = 0.0;
  double sum_ = 0.0;
  double sum_of_squares_ = 0.0;
};

}  // namespace

std::vector<PoseRelation> read_relations(const std::filesystem::path& path) {
  std::vector<PoseRelation> relations;
  datasets::LineReader lines(path);
  while (const auto text = lines.next()) {
    if (text->starts_with('#')) {
      continue;
    }
    const auto [row, line] = exports::parse_number_row(*text, kFormat, path, lines.line_number());
    if (!is_index(row[0]) || !is_index(row[1])) {
      exports::fail_at_line(path, line, "records are whole numbers from 0");
    }
    relations.push_back({static_cast<std::size_t>(row[0]),
                         static_cast<std::size_t>(row[1]),
                         {row[2], row[3], row[4]}});
  }
  return relations;
}

RelationError score_relations(const std::vector<geometry::Pose2>& trajectory,
                              const std::vector<PoseRelation>& relations) {
  if (relations.empty()) {
    throw std::invalid_argument("there are no relations to compare with");
  }
  Spread translation_m;
  Spread rotation_rad;
  for (const PoseRelation& relation : relations) {
    const std::size_t last = std::max(relation.from, relation.to);
    if (last >= trajectory.size()) {
      throw std::invalid_argument("a relation names record " + std::to_string(last) +
                                  ", the trajectory has " + std::to_string(trajectory.size()));
    }
    // Equation (2) of the paper: what is left of the known relation after the estimated one.
    const geometry::Pose2 T_from_to = trajectory[relation.from].inverse() * trajectory[relation.to];
    const geometry::Pose2 left = relation.T_from_to.inverse() * T_from_to;
    translation_m.add(left.position_m().norm());
    rotation_rad.add(std::abs(left.heading_rad()));
  }
  return {relations.size(),
          translation_m.mean(),
          translation_m.sd(),
          rotation_rad.mean(),
          rotation_rad.sd()};
}

}  // namespace echomap::evaluation

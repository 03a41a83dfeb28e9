// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include "host/paper_report/paper_report.hpp"

namespace echomap::tests {

/// The row of an experiment's table with that name. Throws std::out_of_range where there is none.
inline const paper_report::Finding& finding(const paper_report::Experiment& experiment,
                                            const std::string& quantity) {
  const auto found =
      std::ranges::find(experiment.findings, quantity, &paper_report::Finding::quantity);
  if (found == experiment.findings.end()) {
    throw std::out_of_range("no finding " + quantity);
  }
  return *found;
}

}  // namespace echomap::tests

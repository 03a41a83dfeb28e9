// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace differential {

/// What a target is to do. Each number goes over the wire in four bytes, the low one first.
struct Request {
  uint32_t seed;
  uint32_t steps;         ///< Milliseconds of the robot's life.
  uint32_t report_every;  ///< Steps, above 0.
  uint32_t report_from;   ///< No report of a step before.
};

/// All outputs of all steps up to this one.
struct Report {
  uint32_t step;
  uint32_t sum;
  uint32_t sum_of_sums;
};

/// Runs the whole firmware above its hardware layer for the steps of `request`; once in the life of
/// a program, because the robot is a global one.
void run(const Request& request);

/// The target's way to report.
void report(const Report& report);

}  // namespace differential
}  // namespace echomap

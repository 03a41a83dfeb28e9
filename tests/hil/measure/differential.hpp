// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace echomap::tests {

/// All outputs of a robot's firmware up to this step, in two sums.
struct DifferentialReport {
  std::uint32_t step = 0;
  std::uint32_t sum = 0;
  std::uint32_t sum_of_sums = 0;

  bool operator==(const DifferentialReport&) const = default;
};

/// What tests/firmware/differential is asked for: a step is a millisecond of the robot's life.
struct DifferentialRequest {
  std::uint32_t seed = 1;
  std::uint32_t steps = 0;
  std::uint32_t report_every = 1'000;  ///< Steps, above 0.
  std::uint32_t report_from = 0;
};

/// The firmware above its hardware layer, compiled for one chip, in a random world that is the same
/// for all.
class DifferentialTarget {
 public:
  /// "native", "arm" (under qemu-arm) or "avr" (in simavr), as this build has them.
  static std::vector<DifferentialTarget> all();

  const std::string& name() const { return name_; }
  /// Throws std::runtime_error where the program ends early.
  std::vector<DifferentialReport> run(const DifferentialRequest& request) const;

 private:
  DifferentialTarget(std::string name, std::string command)
      : name_(std::move(name)), command_(std::move(command)) {}

  std::string name_;
  std::string command_;  ///< For the shell; an ELF file for "avr".
};

/// The first step at which `left` and `right` have put out something else, if there is one.
std::optional<std::uint32_t> first_difference(const DifferentialTarget& left,
                                              const DifferentialTarget& right,
                                              DifferentialRequest request);

/// What compares all targets with the first one.
struct DifferentialResult {
  std::uint64_t steps = 0;       ///< On each of the targets.
  std::uint64_t mismatches = 0;  ///< Seeds at which a target differs.
  std::vector<std::string> differences;
};

/// Runs `steps` on every target, in runs of 50,000 at most with a seed each.
DifferentialResult compare_targets(std::uint64_t steps, std::uint32_t first_seed);

}  // namespace echomap::tests

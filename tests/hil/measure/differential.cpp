// SPDX-License-Identifier: MIT
#include "tests/hil/measure/differential.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "hil_mock/emulator/avr_machine.hpp"

namespace echomap::tests {
namespace {

constexpr std::uint32_t kStepsOfARun = 50'000;
/// A step takes some 2,000 cycles; this many without a report are a crash.
constexpr std::uint64_t kCyclesOfAStep = 40'000;

std::size_t reports_of(const DifferentialRequest& request) {
  std::size_t count = 0;
  for (std::uint64_t step = request.report_every; step <= request.steps;
       step += request.report_every) {
    count += step >= request.report_from ? 1 : 0;
  }
  return count;
}

std::vector<DifferentialReport> run_in_shell(const std::string& program,
                                             const DifferentialRequest& request) {
  const std::string command =
      program + ' ' + std::to_string(request.seed) + ' ' + std::to_string(request.steps) + ' ' +
      std::to_string(request.report_every) + ' ' + std::to_string(request.report_from);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> output(::popen(command.c_str(), "r"),
                                                               &::pclose);
  std::vector<DifferentialReport> reports;
  DifferentialReport report;
  while (output != nullptr &&
         std::fscanf(output.get(), "%u %u %u", &report.step, &report.sum, &report.sum_of_sums) ==
             3) {
    reports.push_back(report);
  }
  return reports;
}

std::uint32_t number_at(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number |= std::uint32_t{bytes[at + i]} << (8 * i);
  }
  return number;
}

std::vector<DifferentialReport> run_in_simavr(const std::string& elf,
                                              const DifferentialRequest& request) {
  constexpr std::uint64_t kStartCycles = 16'000;
  constexpr std::uint64_t kCyclesAtOnce = 1'000'000;
  constexpr std::size_t kReportBytes = 12;
  emulator::AvrMachine machine(elf);
  std::vector<std::uint8_t> sent;
  machine.usart().on_sent = [&sent](std::uint8_t byte) { sent.push_back(byte); };
  machine.run_to(kStartCycles);  // Now it listens.
  std::array<std::uint8_t, 16> bytes{};
  std::size_t at = 0;
  for (const std::uint32_t number :
       {request.seed, request.steps, request.report_every, request.report_from}) {
    for (unsigned bits = 0; bits < 32; bits += 8) {
      bytes.at(at++) = static_cast<std::uint8_t>(number >> bits);
    }
  }
  machine.usart().receive(bytes);
  const std::size_t wanted = reports_of(request) * kReportBytes;
  const std::uint64_t end = kCyclesOfAStep * (request.steps + 1'000ULL);
  while (sent.size() < wanted && machine.cycle() < end) {
    machine.run_to(machine.cycle() + kCyclesAtOnce);
  }
  std::vector<DifferentialReport> reports;
  for (at = 0; at + kReportBytes <= sent.size(); at += kReportBytes) {
    reports.push_back({number_at(sent, at), number_at(sent, at + 4), number_at(sent, at + 8)});
  }
  return reports;
}

void compare_run(const std::vector<DifferentialTarget>& targets,
                 const DifferentialRequest& request,
                 DifferentialResult& result) {
  for (std::size_t i = 1; i < targets.size(); ++i) {
    const auto step = first_difference(targets.front(), targets[i], request);
    if (step) {
      ++result.mismatches;
      result.differences.push_back("seed " + std::to_string(request.seed) + ", step " +
                                   std::to_string(*step) + ": " + targets[i].name() +
                                   " is not as " + targets.front().name());
    }
  }
}

}  // namespace

std::vector<DifferentialTarget> DifferentialTarget::all() {
  std::vector<DifferentialTarget> targets;
#ifdef ECHOMAP_DIFFERENTIAL_NATIVE
  targets.push_back(DifferentialTarget("native", ECHOMAP_DIFFERENTIAL_NATIVE));
#endif
#ifdef ECHOMAP_DIFFERENTIAL_ARM
  targets.push_back(DifferentialTarget("arm", ECHOMAP_DIFFERENTIAL_ARM));
#endif
#ifdef ECHOMAP_DIFFERENTIAL_AVR
  targets.push_back(DifferentialTarget("avr", ECHOMAP_DIFFERENTIAL_AVR));
#endif
  return targets;
}

std::vector<DifferentialReport> DifferentialTarget::run(const DifferentialRequest& request) const {
  auto reports =
      name_ == "avr" ? run_in_simavr(command_, request) : run_in_shell(command_, request);
  if (reports.size() != reports_of(request)) {
    throw std::runtime_error("differential program for " + name_ + ", seed " +
                             std::to_string(request.seed) + ": ended after " +
                             std::to_string(reports.size()) + " of " +
                             std::to_string(reports_of(request)) + " reports");
  }
  return reports;
}

std::optional<std::uint32_t> first_difference(const DifferentialTarget& left,
                                              const DifferentialTarget& right,
                                              DifferentialRequest request) {
  const auto differing_step = [&]() -> std::optional<std::uint32_t> {
    const auto left_reports = left.run(request);
    const auto right_reports = right.run(request);
    const auto found =
        std::mismatch(left_reports.begin(), left_reports.end(), right_reports.begin());
    if (found.first == left_reports.end()) {
      return std::nullopt;
    }
    return found.first->step;
  };
  const auto within = differing_step();
  if (!within || request.report_every == 1) {
    return within;
  }
  request.report_from = *within - request.report_every + 1;
  request.steps = *within;
  request.report_every = 1;
  return differing_step();
}

DifferentialResult compare_targets(std::uint64_t steps, std::uint32_t first_seed) {
  const auto targets = DifferentialTarget::all();
  if (targets.size() < 2) {
    throw std::runtime_error("there is nothing to compare with: no AVR or ARM compiler is here");
  }
  DifferentialResult result;
  for (DifferentialRequest request{.seed = first_seed}; result.steps < steps; ++request.seed) {
    request.steps =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(kStepsOfARun, steps - result.steps));
    request.report_every = std::min(request.steps, 1'000U);
    compare_run(targets, request, result);
    result.steps += request.steps;
  }
  return result;
}

}  // namespace echomap::tests

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace echomap::paper_report {

/// A mean or a share over runs with its 95 % confidence interval. Without runs the three numbers
/// are not a number.
struct Measured {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
  std::size_t runs = 0;

  bool operator==(const Measured&) const = default;
};

/// Share of runs that succeeded, 0 to 1, with its score interval (Wilson 1927). `successes` is at
/// most `runs`.
Measured measured_share(std::size_t successes, std::size_t runs);

/// Mean of one value per run, in the values' unit, with its interval by Student's t. The interval
/// of a single value is the value.
Measured measured_mean(std::span<const double> values);

/// The same measurement in another unit: value and interval times `factor`, which is above 0. A
/// share times 100 is in percent.
Measured scaled(const Measured& measured, double factor);

/// The measurement for people, as in "6.2 cm (5.1 to 7.3), 20 runs". A single run has no interval.
/// `decimals` is how many digits follow the decimal point.
std::string text_of(const Measured& measured, const std::string& unit, int decimals);

/// The first part of text_of: the value and its unit, as in "6.2 cm".
std::string value_text(const Measured& measured, const std::string& unit, int decimals);

/// What follows value_text in text_of: the interval and the runs, as in " (5.1 to 7.3), 20 runs".
std::string interval_text(const Measured& measured, int decimals);

}  // namespace echomap::paper_report

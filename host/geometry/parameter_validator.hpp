// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace echomap::geometry {

/// Refuses parameters that are out of range by the name of the field, its value and its range:
///
///     ParameterValidator("coastal").positive("tick_s", params.tick_s).within(..);
///
/// Each check throws std::invalid_argument, as "coastal: tick_s = -1 is not above 0". A value that
/// is not a number passes none. Names must outlive the call.
class ParameterValidator {
 public:
  explicit ParameterValidator(std::string_view algorithm) : algorithm_(algorithm) {}

  /// Above 0.
  template <typename Number>
  const ParameterValidator& positive(std::string_view field, Number value) const {
    return above(field, value, 0);
  }
  const ParameterValidator& positive_finite(std::string_view field, double value) const {
    return finite(field, value).positive(field, value);
  }
  /// 0 or above.
  const ParameterValidator& nonnegative_finite(std::string_view field, double value) const {
    return finite(field, value).at_least(field, value, 0);
  }
  template <typename Number, typename Bound>
  const ParameterValidator& above(std::string_view field, Number value, Bound low) const {
    return expect(as_double(value) > as_double(low), field, value, "is not above", low);
  }
  template <typename Number, typename Bound>
  const ParameterValidator& at_least(std::string_view field, Number value, Bound low) const {
    return expect(as_double(value) >= as_double(low), field, value, "is below", low);
  }
  template <typename Number, typename Bound>
  const ParameterValidator& below(std::string_view field, Number value, Bound high) const {
    return expect(as_double(value) < as_double(high), field, value, "is not below", high);
  }
  template <typename Number, typename Bound>
  const ParameterValidator& at_most(std::string_view field, Number value, Bound high) const {
    return expect(as_double(value) <= as_double(high), field, value, "is above", high);
  }
  /// From `low` to `high`, both included.
  const ParameterValidator& within(std::string_view field,
                                   double value,
                                   double low,
                                   double high) const;
  const ParameterValidator& finite(std::string_view field, double value) const;
  /// A rule that is not about one number: `rule` says what must hold.
  const ParameterValidator& require(bool holds, std::string_view rule) const;

 private:
  template <typename Number>
  static double as_double(Number value) {
    return static_cast<double>(value);
  }

  template <typename Number, typename Bound>
  const ParameterValidator& expect(bool holds,
                                   std::string_view field,
                                   Number value,
                                   std::string_view relation,
                                   Bound bound) const {
    return expect_double(holds, field, as_double(value), relation, as_double(bound));
  }
  const ParameterValidator& expect_double(bool holds,
                                          std::string_view field,
                                          double value,
                                          std::string_view relation,
                                          double bound) const;

  std::string_view algorithm_;
};

}  // namespace echomap::geometry

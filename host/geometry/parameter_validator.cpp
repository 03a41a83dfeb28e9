// SPDX-License-Identifier: MIT
#include "host/geometry/parameter_validator.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace echomap::geometry {

namespace {

template <typename... Parts>
[[noreturn]] void refuse(std::string_view algorithm, const Parts&... parts) {
  std::ostringstream message;
  message << algorithm << ": ";
  (message << ... << parts);
  throw std::invalid_argument(message.str());
}

}  // namespace

const ParameterValidator& ParameterValidator::within(std::string_view field,
                                                     double value,
                                                     double low,
                                                     double high) const {
  if (std::isnan(value) || value < low || value > high) {
    refuse(algorithm_, field, " = ", value, " is outside ", low, " .. ", high);
  }
  return *this;
}

const ParameterValidator& ParameterValidator::finite(std::string_view field, double value) const {
  if (!std::isfinite(value)) {
    refuse(algorithm_, field, " = ", value, " is not finite");
  }
  return *this;
}

const ParameterValidator& ParameterValidator::require(bool holds, std::string_view rule) const {
  if (!holds) {
    refuse(algorithm_, rule);
  }
  return *this;
}

const ParameterValidator& ParameterValidator::expect_double(bool holds,
                                                            std::string_view field,
                                                            double value,
                                                            std::string_view relation,
                                                            double bound) const {
  if (!holds) {
    refuse(algorithm_, field, " = ", value, " ", relation, " ", bound);
  }
  return *this;
}

}  // namespace echomap::geometry

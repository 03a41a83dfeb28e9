// SPDX-License-Identifier: MIT
#include "host/localization/ekf_outcome.hpp"

namespace echomap::localization {

EkfOutcome outcome_of(MeasurementFault fault) {
  switch (fault) {
    case MeasurementFault::kBadRange:
      return EkfOutcome::kBadRange;
    case MeasurementFault::kBadCovariance:
      return EkfOutcome::kBadCovariance;
    case MeasurementFault::kNotFinite:
      break;
  }
  return EkfOutcome::kNotFinite;
}

}  // namespace echomap::localization

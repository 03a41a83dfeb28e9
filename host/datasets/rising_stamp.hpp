// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace echomap::datasets {

/// Lets stamps pass that rise. Logs whose stamps went through single precision repeat one stamp for
/// hundreds of records: a record whose stamp does not rise has none, rather than a wrong one.
class RisingStamp {
 public:
  std::optional<double> accept(double stamp_s) {
    if (last_s_ && stamp_s <= *last_s_) {
      return std::nullopt;
    }
    last_s_ = stamp_s;
    return stamp_s;
  }

 private:
  std::optional<double> last_s_;
};

}  // namespace echomap::datasets

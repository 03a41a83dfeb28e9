// SPDX-License-Identifier: MIT
#include "host/source_search/source_estimate.hpp"

namespace echomap::source_search {

const char* name_of(SourceVerdict verdict) {
  switch (verdict) {
    case SourceVerdict::kUndecided:
      return "undecided";
    case SourceVerdict::kFound:
      return "found";
    case SourceVerdict::kNone:
      return "none";
  }
  return "";
}

}  // namespace echomap::source_search

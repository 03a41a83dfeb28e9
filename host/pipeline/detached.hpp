// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

namespace echomap::pipeline {

/// What may be written: a copy where a snapshot still shares the part that there is.
template <class Part>
Part& detached(std::shared_ptr<Part>& part) {
  if (part.use_count() > 1) {
    part = std::make_shared<Part>(*part);
  }
  return *part;
}

}  // namespace echomap::pipeline

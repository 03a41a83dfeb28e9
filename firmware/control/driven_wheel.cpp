// SPDX-License-Identifier: MIT
#include "firmware/control/driven_wheel.hpp"

namespace echomap {
namespace control {

void DrivenWheel::begin(int16_t count) {
  controller_.reset();
  last_count_ = count;
}

void DrivenWheel::follow(int16_t count) {
  const int16_t turned = static_cast<int16_t>(count - last_count_);
  last_count_ = count;
  motor_.set(controller_.update(turned));
}

void DrivenWheel::release() { motor_.set(0); }

}  // namespace control
}  // namespace echomap

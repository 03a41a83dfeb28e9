// SPDX-License-Identifier: MIT
#include "hil_mock/runner/pin_log.hpp"

#include <sstream>
#include <stdexcept>

namespace echomap::runner {

using world::DriverInputs;
using world::PinSignal;

std::string text_of(const PinSignal& pin) {
  if (pin.source != PinSignal::Source::kDriven) {
    return pin.source == PinSignal::Source::kFloating ? "z" : "u";
  }
  if (!pin.makes_pulses()) {
    return pin.high_share() > 0.0 ? "1" : "0";
  }
  std::ostringstream text;
  if (pin.high_from > 0.0) {
    text << '~' << pin.high_from;
  } else {
    text << pin.high_until;
  }
  text << '/' << pin.period_us;
  return text.str();
}

PinLog::PinLog(const std::filesystem::path& file) : lines_(file) {
  lines_ << "sim_ns,left_pwm,left_in1,left_in2,right_pwm,right_in1,right_in2" << std::endl;
  if (!lines_) {
    throw std::runtime_error(file.string() + ": cannot be written");
  }
}

void PinLog::note(std::int64_t now_ns, const DriverInputs& left, const DriverInputs& right) {
  if (last_ && last_->first == left && last_->second == right) {
    return;
  }
  last_ = {left, right};
  lines_ << now_ns;
  for (const DriverInputs& inputs : {left, right}) {
    for (const PinSignal& pin : {inputs.pwm, inputs.in1, inputs.in2}) {
      lines_ << ',' << text_of(pin);
    }
  }
  lines_ << std::endl;
}

}  // namespace echomap::runner

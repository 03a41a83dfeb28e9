// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/reset_watcher.hpp"

#include <utility>

namespace echomap::emulator {

ResetWatcher::ResetWatcher(avr_t& avr, std::function<void()> on_reset) {
  module_.on_reset = std::move(on_reset);
  module_.kind = "reset watcher";
  module_.reset = [](avr_io_t* io) { static_cast<Module*>(io)->on_reset(); };
  avr_register_io(&avr, &module_);
}

}  // namespace echomap::emulator

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <sim_avr.h>
#include <sim_io.h>

namespace echomap::emulator {

/// Hears of every reset, the watchdog's too, as an I/O module of simavr's chain.
class ResetWatcher {
 public:
  /// The watcher outlives `avr`.
  ResetWatcher(avr_t& avr, std::function<void()> on_reset);
  ResetWatcher(const ResetWatcher&) = delete;
  ResetWatcher& operator=(const ResetWatcher&) = delete;

 private:
  struct Module : avr_io_t {
    std::function<void()> on_reset;
  };

  Module module_{};
};

}  // namespace echomap::emulator

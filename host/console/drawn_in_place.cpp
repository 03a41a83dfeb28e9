// SPDX-License-Identifier: MIT
#include "host/console/drawn_in_place.hpp"

namespace echomap::console {
namespace {

/// There is one terminal, and one thing at a time is drawn on it.
DrawnInPlace* on_the_terminal = nullptr;

}  // namespace

DrawnInPlace::~DrawnInPlace() { note_gone(); }

void DrawnInPlace::note_drawn() { on_the_terminal = this; }

void DrawnInPlace::note_gone() {
  if (on_the_terminal == this) {
    on_the_terminal = nullptr;
  }
}

void make_way_for_a_line() {
  if (on_the_terminal != nullptr) {
    on_the_terminal->clear();
  }
}

}  // namespace echomap::console

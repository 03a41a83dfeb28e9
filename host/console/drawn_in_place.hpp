// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::console {

/// Something that is drawn again in place on a terminal, one at a time, and makes way for lines
/// that are printed there.
class DrawnInPlace {
 public:
  DrawnInPlace() = default;
  DrawnInPlace(const DrawnInPlace&) = delete;
  DrawnInPlace& operator=(const DrawnInPlace&) = delete;

  /// Wipes what is drawn, for other output; it comes back when it is next drawn.
  virtual void clear() = 0;

 protected:
  virtual ~DrawnInPlace();
  /// This is on the terminal from now on.
  void note_drawn();
  /// This is no longer on the terminal, or no longer drawn again there.
  void note_gone();
};

/// Wipes what is drawn in place on the terminal now, if anything is, so that a line can be printed
/// there.
void make_way_for_a_line();

}  // namespace echomap::console

// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "host/apps/member_report.hpp"
#include "host/exploration/explorer.hpp"

namespace echomap::apps {

/// An explorer of a team that says at its end what became of meeting others.
template <class TeamDriver>
class CountedEncounters final : public exploration::Explorer {
 public:
  /// `encounters` outlives this.
  template <class... Arguments>
  explicit CountedEncounters(MemberEncounters& encounters, Arguments&&... arguments)
      : driver_(std::forward<Arguments>(arguments)...), encounters_(encounters) {}
  ~CountedEncounters() override { encounters_.add(driver_.encounters(), driver_.is_in_deadlock()); }
  CountedEncounters(const CountedEncounters&) = delete;
  CountedEncounters& operator=(const CountedEncounters&) = delete;

  exploration::Motion next(const pipeline::Snapshot& snapshot,
                           exploration::MotionResult last) override {
    return driver_.next(snapshot, last);
  }
  exploration::Intent intent() const override { return driver_.intent(); }

 private:
  TeamDriver driver_;
  MemberEncounters& encounters_;
};

}  // namespace echomap::apps

// SPDX-License-Identifier: MIT
#include "tests/sessions/recoveries.hpp"

#include <algorithm>
#include <memory>
#include <random>

#include "tests/hil/emulated_board.hpp"
#include "tests/sessions/simulated_session.hpp"

namespace echomap::tests {
namespace {

using exploration::MotionResult;

/// Motions to try before a link counts as lost.
constexpr int kTries = 3;

/// A session whose link breaks at planned moments.
class BreakingLink {
 public:
  BreakingLink(const std::filesystem::path& elf, Break kind, std::uint32_t seed)
      : chip_(make_emulated_board(elf)),
        sim_(chip_->pins(), "empty_room", seed),
        kind_(kind),
        random_(seed) {
    sim_.each_step = [this] { step(); };
    sim_.session().connect();
  }

  /// Breaks the link in the next drive, to the middle of the room and beyond; true where a later
  /// one gets there.
  bool survives() {
    const double distance_m = sim_.simulation().world().T_world_robot().x_m() > 1.25 ? -0.3 : 0.3;
    const double error_before_m = sim_.position_error_m();
    plan_break();
    bool arrived = false;
    for (int i = 0; i < kTries && !arrived && !sim_.session().end(); ++i) {
      const auto result = sim_.session().execute(exploration::Drive{distance_m});
      arrived = result == MotionResult::kReached && phase_ == Phase::kWhole;
    }
    worst_position_m_ = std::max(worst_position_m_, sim_.position_error_m() - error_before_m);
    return arrived && !sim_.session().end();
  }

  double longest_s() const { return longest_s_; }
  double worst_position_m() const { return worst_position_m_; }

 private:
  enum class Phase : std::uint8_t { kWhole, kPlanned, kOut, kBootLoader, kBack };

  double between(double least, double most) {
    return least + (most - least) * double(random_() % 10'000) / 10'000.0;
  }

  void plan_break() {
    const bool cable = kind_ == Break::kUnplugged || kind_ == Break::kReplugged;
    const bool boots = kind_ == Break::kReplugged || kind_ == Break::kResetPin;
    phase_ = Phase::kPlanned;
    resets_before_ = sim_.session().link().statistics().resets_seen;
    break_at_s_ = sim_.now_s() + between(0.05, 1.0);
    plug_at_s_ = break_at_s_ + (cable ? between(0.3, 3.0) : 0.0);
    back_at_s_ = plug_at_s_ + (boots ? between(0.5, 2.0) : 0.0);
  }

  void step() {
    const double now_s = sim_.now_s();
    if (phase_ == Phase::kPlanned && now_s >= break_at_s_) {
      phase_ = Phase::kOut;
      sim_.cable().plugged = kind_ != Break::kUnplugged && kind_ != Break::kReplugged;
      if (kind_ == Break::kWatchdogReset) {
        chip_->hang();
      }
    }
    if (phase_ == Phase::kOut && now_s >= plug_at_s_) {
      phase_ = Phase::kBootLoader;
      sim_.cable() = Cable{.plugged = true, .boot_loader = now_s < back_at_s_};
    }
    if (phase_ == Phase::kBootLoader && sim_.cable().boot_loader) {
      chip_->pull_reset_pin();  // and again: it stays there
    }
    if (phase_ == Phase::kBootLoader && now_s >= back_at_s_) {
      phase_ = Phase::kBack;
      sim_.cable().boot_loader = false;
    }
    if (phase_ == Phase::kBack && is_heard_again()) {
      phase_ = Phase::kWhole;
      longest_s_ = std::max(longest_s_, now_s - back_at_s_);
    }
  }

  /// A link that has not seen the board's reset yet still trusts its old boot.
  bool is_heard_again() const {
    const robot_link::RobotLink& link = sim_.session().link();
    const bool seen = kind_ == Break::kUnplugged || link.statistics().resets_seen > resets_before_;
    return seen && link.state() == robot_link::LinkState::kReady;
  }

  std::unique_ptr<EmulatedBoard> chip_;
  SimulatedSession sim_;
  Break kind_;
  std::mt19937 random_;
  Phase phase_ = Phase::kWhole;
  std::uint64_t resets_before_ = 0;
  double break_at_s_ = 0.0;
  double plug_at_s_ = 0.0;
  double back_at_s_ = 0.0;
  double longest_s_ = 0.0;
  double worst_position_m_ = 0.0;
};

}  // namespace

Recoveries measure_recoveries(const std::filesystem::path& elf,
                              Break kind,
                              int breaks,
                              std::uint32_t seed) {
  BreakingLink link(elf, kind, seed);
  Recoveries result;
  for (int i = 0; i < breaks; ++i) {
    ++result.breaks;
    result.recovered += link.survives() ? 1 : 0;
  }
  result.longest_s = link.longest_s();
  result.worst_position_m = link.worst_position_m();
  return result;
}

}  // namespace echomap::tests

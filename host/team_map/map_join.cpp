// SPDX-License-Identifier: MIT
#include "host/team_map/map_join.hpp"

#include <algorithm>

#include "host/geometry/parameter_validator.hpp"
#include "host/slam/stop_stand.hpp"

namespace echomap::team_map {

namespace {

/// Whether a placement would be sure if there were no other one.
bool speaks_for(const SureEvidence& sure, const MapEvidence& evidence) {
  return evidence.readings >= sure.min_readings && evidence.gain >= sure.min_gain &&
         evidence.loss_per_reading() <= sure.max_loss && evidence.matched >= sure.min_matched &&
         evidence.matched_share() >= sure.min_matched_share;
}

}  // namespace

void validate(const SureEvidence& sure) {
  geometry::ParameterValidator("sure evidence")
      .positive("max_loss", sure.max_loss)
      .positive("min_readings", sure.min_readings)
      .positive("min_gain", sure.min_gain)
      .within("min_matched_share", sure.min_matched_share, 0.0, 1.0)
      .within("max_rival_share", sure.max_rival_share, 0.0, 1.0)
      .within("max_rival_wall_share", sure.max_rival_wall_share, 0.0, 1.0)
      .at_least("refuted_loss", sure.refuted_loss, sure.max_loss);
}

void validate(const MapJoinParams& params) {
  geometry::ParameterValidator("map join")
      .positive("min_stops", params.min_stops)
      .positive("max_scored_placements", params.max_scored_placements)
      .positive("agreeing_looks", params.agreeing_looks)
      .positive("same_m", params.same_m)
      .positive("same_rad", params.same_rad)
      .at_least("undone_loss", params.undone_loss, params.sure.max_loss)
      .positive("undoing_looks", params.undoing_looks);
  validate(params.sure);
}

void MapJoin::update(const RobotMap& first, const RobotMap& second) {
  if (joined_) {
    check(first, second);
  } else if (are_large_enough(first, second)) {
    look(first, second);
  }
}

bool MapJoin::are_large_enough(const RobotMap& first, const RobotMap& second) const {
  return std::min(first.submaps().size(), second.submaps().size()) >= params_.min_stops;
}

std::vector<ScoredPlacement> MapJoin::proposals(const RobotMap& first,
                                                const RobotMap& second) const {
  std::vector<ScoredPlacement> proposals;
  for (const mapping::MapPlacement& placement :
       mapping::find_placements(first.map(), second.map(), params_.placement)) {
    if (proposals.size() == params_.max_scored_placements) {
      break;
    }
    const geometry::Pose2 refined = refined_placement(first, second, placement.T_previous_later);
    if (std::none_of(proposals.begin(), proposals.end(), [&](const ScoredPlacement& other) {
          return slam::is_near(refined, other.T_first_second, params_.same_m, params_.same_rad);
        })) {
      proposals.push_back({refined, evidence_for(first, second, refined), placement.weight_m()});
    }
  }
  std::stable_sort(proposals.begin(), proposals.end(), [](const auto& one, const auto& other) {
    return one.evidence.weight() > other.evidence.weight();
  });
  return proposals;
}

void MapJoin::look(const RobotMap& first, const RobotMap& second) {
  scored_ = proposals(first, second);
  if (!is_sure()) {
    agreeing_ = 0;
    return;
  }
  const geometry::Pose2& best = scored_.front().T_first_second;
  const bool agrees =
      agreeing_ > 0 && slam::is_near(*candidate_, best, params_.same_m, params_.same_rad);
  agreeing_ = agrees ? agreeing_ + 1 : 1;
  candidate_ = best;
  if (agreeing_ >= params_.agreeing_looks) {
    join(best);
  }
}

void MapJoin::join(const geometry::Pose2& T_first_second) {
  joined_ = T_first_second;
  contradicting_ = 0;
  ++joins_;
}

bool MapJoin::accept_join(const geometry::Pose2& T_first_second) {
  if (joined_ || undone_ > 0) {
    return false;
  }
  join(T_first_second);
  return true;
}

void MapJoin::undo() {
  if (joined_) {
    joined_.reset();
    ++undone_;
  }
  agreeing_ = 0;
  contradicting_ = 0;
}

void MapJoin::try_at(const RobotMap& first,
                     const RobotMap& second,
                     const geometry::Pose2& T_first_second) {
  if (!are_large_enough(first, second)) {
    return;
  }
  const geometry::Pose2 refined = refined_placement(first, second, T_first_second);
  const bool stays = slam::is_near(T_first_second, refined, params_.same_m, params_.same_rad);
  const geometry::Pose2& tried = stays ? refined : T_first_second;
  scored_ = {{tried, evidence_for(first, second, tried), 0.0}};
  agreeing_ = 0;
  if (stays && is_sure()) {
    join(refined);
    return;
  }
  const MapEvidence& evidence = scored_.front().evidence;
  const bool speaks_against = evidence.readings >= params_.sure.min_readings &&
                              evidence.loss_per_reading() > params_.undone_loss;
  contradicting_ = speaks_against ? contradicting_ + 1 : 0;
}

bool MapJoin::is_sure() const {
  return !scored_.empty() && speaks_for(params_.sure, scored_.front().evidence) && !has_rival();
}

bool MapJoin::has_rival() const {
  const SureEvidence& sure = params_.sure;
  const ScoredPlacement& best = scored_.front();
  return std::any_of(scored_.begin() + 1, scored_.end(), [&](const ScoredPlacement& other) {
    const bool is_refuted = other.evidence.readings >= sure.min_readings &&
                            other.evidence.loss_per_reading() > sure.refuted_loss;
    return other.evidence.weight() > sure.max_rival_share * best.evidence.weight() ||
           (!is_refuted && other.wall_weight_m > sure.max_rival_wall_share * best.wall_weight_m);
  });
}

/// Two rooms may look alike as long as neither robot has seen the other one's. A map that is bent
/// for a while loses much of its readings where it truly lies, but has the most wall there.
bool MapJoin::is_outdone(const ScoredPlacement& join,
                         const std::vector<ScoredPlacement>& proposals) const {
  const auto is_at_join = [&](const ScoredPlacement& proposal) {
    return slam::is_near(
        join.T_first_second, proposal.T_first_second, params_.same_m, params_.same_rad);
  };
  const auto same = std::find_if(proposals.begin(), proposals.end(), is_at_join);
  const double wall_weight_m = same == proposals.end() ? 0.0 : same->wall_weight_m;
  return std::any_of(proposals.begin(), proposals.end(), [&](const ScoredPlacement& other) {
    return !is_at_join(other) && speaks_for(params_.sure, other.evidence) &&
           params_.sure.max_rival_share * other.evidence.weight() > join.evidence.weight() &&
           other.wall_weight_m > wall_weight_m;
  });
}

void MapJoin::check(const RobotMap& first, const RobotMap& second) {
  const geometry::Pose2 refined = refined_placement(first, second, *joined_);
  const MapEvidence evidence = evidence_for(first, second, refined);
  scored_ = {{refined, evidence, 0.0}};
  const bool holds = slam::is_near(*joined_, refined, params_.same_m, params_.same_rad) &&
                     evidence.readings >= 0.5 * params_.sure.min_readings &&
                     evidence.loss_per_reading() <= params_.undone_loss &&
                     !is_outdone(scored_.front(), proposals(first, second));
  contradicting_ = holds ? 0 : contradicting_ + 1;
  if (holds) {
    joined_ = refined;
  } else if (contradicting_ >= params_.undoing_looks) {
    undo();
  }
}

}  // namespace echomap::team_map

// SPDX-License-Identifier: MIT
#include "host/team_map/map_join.hpp"

#include <algorithm>

#include "host/geometry/parameter_validator.hpp"
#include "host/slam/stop_stand.hpp"

namespace echomap::team_map {

void validate(const SureEvidence& sure) {
  geometry::ParameterValidator("sure evidence")
      .positive("max_loss", sure.max_loss)
      .positive("min_gain", sure.min_gain)
      .within("min_matched_share", sure.min_matched_share, 0.0, 1.0)
      .positive("max_range_rms_m", sure.max_range_rms_m)
      .at_least("max_loss_by_walls", sure.max_loss_by_walls, sure.max_loss)
      .at_least("max_range_rms_by_walls_m", sure.max_range_rms_by_walls_m, sure.max_range_rms_m)
      .within("max_rival_share", sure.max_rival_share, 0.0, 1.0)
      .within("max_rival_wall_share", sure.max_rival_wall_share, 0.0, 1.0)
      .at_least("refuted_loss", sure.refuted_loss, sure.max_loss_by_walls);
}

void validate(const MapJoinParams& params) {
  geometry::ParameterValidator("map join")
      .positive("min_stops", params.min_stops)
      .positive("judged", params.judged)
      .positive("agreeing_looks", params.agreeing_looks)
      .positive("same_m", params.same_m)
      .positive("same_rad", params.same_rad)
      .at_least("undone_loss", params.undone_loss, params.sure.max_loss_by_walls)
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

void MapJoin::look(const RobotMap& first, const RobotMap& second) {
  judged_.clear();
  for (const mapping::MapPlacement& placement :
       mapping::find_placements(first.map(), second.map(), params_.placement)) {
    if (judged_.size() == params_.judged) {
      break;
    }
    const geometry::Pose2 refined = refined_placement(first, second, placement.T_previous_later);
    if (std::none_of(judged_.begin(), judged_.end(), [&](const JudgedPlacement& other) {
          return slam::is_near(refined, other.T_first_second, params_.same_m, params_.same_rad);
        })) {
      judged_.push_back({refined, evidence_for(first, second, refined), placement.weight_m()});
    }
  }
  std::stable_sort(judged_.begin(), judged_.end(), [](const auto& one, const auto& other) {
    return one.evidence.weight() > other.evidence.weight();
  });
  if (!is_sure(params_.sure)) {
    agreeing_ = 0;
    return;
  }
  const geometry::Pose2& best = judged_.front().T_first_second;
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
  judged_ = {{tried, evidence_for(first, second, tried), 0.0}};
  agreeing_ = 0;
  if (stays && is_sure(params_.sure)) {
    join(refined);
    return;
  }
  const MapEvidence& evidence = judged_.front().evidence;
  const bool speaks_against = evidence.readings >= params_.sure.min_readings &&
                              evidence.loss_per_reading() > params_.undone_loss;
  contradicting_ = speaks_against ? contradicting_ + 1 : 0;
}

bool MapJoin::is_sure(const SureEvidence& sure) const {
  if (judged_.empty()) {
    return false;
  }
  const MapEvidence& best = judged_.front().evidence;
  const bool alone = is_alone_by_walls();
  return best.readings >= sure.min_readings && best.gain >= sure.min_gain &&
         best.loss_per_reading() <= (alone ? sure.max_loss_by_walls : sure.max_loss) &&
         best.matched >= sure.min_matched && best.matched_share() >= sure.min_matched_share &&
         best.range_rms_m <= (alone ? sure.max_range_rms_by_walls_m : sure.max_range_rms_m) &&
         !has_rival(sure);
}

bool MapJoin::has_rival(const SureEvidence& sure) const {
  const JudgedPlacement& best = judged_.front();
  return std::any_of(judged_.begin() + 1, judged_.end(), [&](const JudgedPlacement& other) {
    const bool is_refuted = other.evidence.readings >= sure.min_readings &&
                            other.evidence.loss_per_reading() > sure.refuted_loss;
    return other.evidence.weight() > sure.max_rival_share * best.evidence.weight() ||
           (!is_refuted && other.wall_weight_m > sure.max_rival_wall_share * best.wall_weight_m);
  });
}

bool MapJoin::is_alone_by_walls() const {
  const mapping::MapPlacementParams& walls = params_.placement;
  const double best_m = judged_.front().wall_weight_m;
  return best_m >= walls.min_common_m &&
         std::all_of(judged_.begin() + 1, judged_.end(), [&](const JudgedPlacement& other) {
           return other.wall_weight_m <= walls.max_rival_share * best_m &&
                  best_m - other.wall_weight_m >= walls.min_lead_m;
         });
}

void MapJoin::check(const RobotMap& first, const RobotMap& second) {
  const geometry::Pose2 refined = refined_placement(first, second, *joined_);
  const MapEvidence evidence = evidence_for(first, second, refined);
  judged_ = {{refined, evidence, 0.0}};
  const bool holds = slam::is_near(*joined_, refined, params_.same_m, params_.same_rad) &&
                     evidence.readings >= params_.sure.min_readings / 2 &&
                     evidence.loss_per_reading() <= params_.undone_loss;
  contradicting_ = holds ? 0 : contradicting_ + 1;
  if (holds) {
    joined_ = refined;
  } else if (contradicting_ >= params_.undoing_looks) {
    undo();
  }
}

}  // namespace echomap::team_map

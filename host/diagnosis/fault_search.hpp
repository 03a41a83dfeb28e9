// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/diagnosis/fault.hpp"
#include "host/diagnosis/stand_agreement.hpp"
#include "host/diagnosis/stand_log.hpp"

namespace echomap::diagnosis {

/// How far a sound robot is from its profile, standard deviations; relative, and of the pan's zero.
struct SoundRobot {
  double wheel_size = 0.015;
  double wheel_mismatch = 0.008;
  double track = 0.03;
  double pan_rad = 0.015;
  double range = 0.01;
};

/// What robots and stands are compared by.
struct FaultSearchParams {
  SoundRobot sound;
  StandAgreementParams agreement;
};

/// A robot with one fault at most that has heard what was heard, as well as one can.
struct Explanation {
  Fault fault;
  double log_posterior = 0.0;  ///< But for a constant; without what faults cost a priori.
};

/// The best explanation by each kind of fault, the likeliest first.
std::vector<Explanation> explain(const StandLog& log, const FaultSearchParams& params = {});

}  // namespace echomap::diagnosis

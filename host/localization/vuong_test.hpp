// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace echomap::localization {

/// Vuong's test between two models that are both a little wrong (Vuong 1989, equation 5.6): by how
/// many standard deviations the mean of the differences `better[i] - worse[i]` is above 0. Both are
/// logarithms of the likelihood of the same observations, two or more.
double vuong_statistic(std::span<const double> better, std::span<const double> worse);

/// How probable the worse of two models is against the better one, by that many deviations.
double odds_of_worse(double deviations);

}  // namespace echomap::localization

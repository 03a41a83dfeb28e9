// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::optimization {

/// The inlier share of a residual. `squared_error` is its squared Mahalanobis distance (without a
/// unit), `kernel` counts standard deviations: 1 without error, 1/2 where the distance is `kernel`,
/// 0 for an outlier. It is Cauchy's robust weight. Its square is the robust weight of Geman and
/// McClure (1985), and times the squared error it is their cost (weights of iteratively reweighted
/// least squares: Triggs et al. 1999, section 3.2).
inline double inlier_share(double squared_error, double kernel) {
  return 1.0 / (1.0 + squared_error / (kernel * kernel));
}

/// The robust weight of Geman and McClure: 1/4 where the distance is `kernel`.
inline double geman_mcclure_weight(double squared_error, double kernel) {
  const double share = inlier_share(squared_error, kernel);
  return share * share;
}

}  // namespace echomap::optimization

// SPDX-License-Identifier: MIT
import type { Covariance } from '../protocol/messages';

/** The 95 % quantile of chi-squared with two degrees of freedom. */
const chiSquared95 = 5.991;

export interface Ellipse {
  /** Semi-axes, metres; the first is the longer one. */
  majorM: number;
  minorM: number;
  /** Of the longer axis, radians. */
  angle: number;
}

/** Holds the position with 95 % probability; null where the covariance is none. */
export function ellipse95(covariance: Covariance | null): Ellipse | null {
  if (!covariance) return null;
  const { xx, xy, yy } = covariance;
  const middle = (xx + yy) / 2;
  const spread = Math.hypot((xx - yy) / 2, xy);
  const minor = Math.max(0, middle - spread);
  if (!Number.isFinite(middle + spread) || middle + spread < 0) return null;
  return {
    majorM: Math.sqrt(chiSquared95 * (middle + spread)),
    minorM: Math.sqrt(chiSquared95 * minor),
    angle: 0.5 * Math.atan2(2 * xy, xx - yy),
  };
}

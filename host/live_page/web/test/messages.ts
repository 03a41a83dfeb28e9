// SPDX-License-Identifier: MIT
import * as encode from '../dev/mock_encode.mjs';

export { encode };

export interface MotionValues {
  clockMs: number;
  pose: number[];
  covariance: number[];
  headingStddev: number;
  odometry: number[];
  truth: number[];
  ping: { bearing: number; range: number; number: number; outcome: number };
}

export function motion(time: number, changes: Partial<MotionValues> = {}): Uint8Array {
  return encode.motion(time, {
    clockMs: time * 1000,
    pose: [time, 2, 0.5],
    covariance: [0.01, 0.002, 0.02],
    headingStddev: 0.05,
    odometry: [time, 2.5, 0.25],
    truth: [NaN, NaN, NaN],
    ping: { bearing: 0.25, range: 1.5, number: 7, outcome: 1 },
    ...changes,
  });
}

export function tile(time: number, x: number, y: number, cell: number): Uint8Array {
  return encode.tile(time, x, y, new Uint8Array(64 * 64).fill(cell));
}

export function state(time: number, mode: string): Uint8Array {
  return encode.state(time, { mode });
}

// SPDX-License-Identifier: MIT
import type { Steering } from './drive_sampler';

const deadZone = 0.12;

/** Of a stick's deflection, right and down positive, in shares of its travel. */
export function steeringOfStick(right: number, down: number): Steering {
  const length = Math.hypot(right, down);
  if (length < deadZone) return { forward: 0, turn: 0 };
  const share = (Math.min(1, length) - deadZone) / (1 - deadZone) / length;
  return { forward: -down * share + 0, turn: -right * share + 0 };
}

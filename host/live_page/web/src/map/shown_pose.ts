// SPDX-License-Identifier: MIT
import type { Motion, Pose } from '../protocol/messages';
import { wrapAngle } from '../run/view';

const glideMs = 60;
const jumpM = 0.4;

/** Glides from motion to motion, so that the robot does not jerk. */
export class ShownPose {
  private motion: Motion | null = null;
  private from: Pose | null = null;
  private startMs = 0;

  /** Null while the pose is unknown. */
  at(motion: Motion | null, nowMs: number): Pose | null {
    if (!motion || !Number.isFinite(motion.pose.x + motion.pose.y + motion.pose.heading)) {
      this.motion = this.from = null;
      return null;
    }
    if (motion !== this.motion) {
      this.from = this.motion ? this.glide(nowMs) : motion.pose;
      this.motion = motion;
      this.startMs = nowMs;
    }
    return this.glide(nowMs);
  }

  isGliding(nowMs: number): boolean {
    return this.motion !== null && nowMs - this.startMs < glideMs;
  }

  private glide(nowMs: number): Pose {
    const to = this.motion!.pose;
    const from = this.from ?? to;
    const share = Math.min(1, (nowMs - this.startMs) / glideMs);
    if (share >= 1 || Math.hypot(to.x - from.x, to.y - from.y) > jumpM) return to;
    return {
      x: from.x + (to.x - from.x) * share,
      y: from.y + (to.y - from.y) * share,
      heading: from.heading + wrapAngle(to.heading - from.heading) * share,
    };
  }
}

// SPDX-License-Identifier: MIT
import type { Pose } from '../protocol/messages';
import type { Camera } from './camera';
import { type Box, type Context, drawLabel, labelBox, overlap } from './draw_shapes';
import type { Palette } from './palette';

const robotRadius = 16;

/** Labels of a map that cover neither each other nor the robot. */
export class LabelSpace {
  private readonly taken: Box[] = [];

  constructor(
    private readonly context: Context,
    camera: Camera,
    pose: Pose | null,
    private readonly palette: Palette,
  ) {
    if (!pose) return;
    const [x, y] = camera.toScreen(pose.x, pose.y);
    const box = { left: x - robotRadius, top: y - robotRadius, right: x + robotRadius, bottom: y + robotRadius };
    this.taken.push(box);
  }

  /** At the first height that is free; where none is, at the first one if it must be read, else nowhere. */
  place(text: string, x: number, heights: [number, ...number[]], must = false): void {
    const boxAt = (y: number): Box => labelBox(this.context, text, x, y);
    const free = heights.find((y) => !this.taken.some((box) => overlap(box, boxAt(y))));
    const y = free ?? (must ? heights[0] : null);
    if (y === null) return;
    this.taken.push(boxAt(y));
    drawLabel(this.context, text, x, y, this.palette);
  }
}

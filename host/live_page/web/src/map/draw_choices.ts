// SPDX-License-Identifier: MIT
import type { Choice, Pose } from '../protocol/messages';
import { planOf } from '../run/plan';
import type { View } from '../run/view';
import type { Camera } from './camera';
import { type Context, strokeWithHalo } from './draw_shapes';
import type { LabelSpace } from './label_space';
import type { Palette } from './palette';

const labelGap = 12;

/** Of the floor that a choice promises. */
function radiusOf(choice: Choice): number {
  return Math.min(40, 8 + 9 * Math.sqrt(Math.max(0, choice.gain_m2)));
}

/** Places where the robot could go, and the one where it does. */
export function drawChoices(context: Context, camera: Camera, view: View, pose: Pose | null, palette: Palette): void {
  const why = planOf(view.state);
  for (const choice of why?.choices ?? []) {
    const [x, y] = camera.toScreen(...choice.at);
    context.strokeStyle = context.fillStyle = choice.chosen ? palette.chosen : palette.choice;
    context.lineCap = 'round';
    context.lineWidth = choice.chosen ? 3.5 : 1.5;
    context.beginPath();
    context.arc(x, y, radiusOf(choice), 0, 2 * Math.PI);
    context.globalAlpha = choice.chosen ? 0.3 : 0.14;
    context.fill();
    context.globalAlpha = 1;
    strokeWithHalo(context, palette.halo);
  }
  if (!why?.goal) return;
  const [x, y] = camera.toScreen(...why.goal);
  context.strokeStyle = palette.chosen;
  context.lineWidth = 2.5;
  if (pose) {
    context.setLineDash([3, 6]);
    context.beginPath();
    context.moveTo(...camera.toScreen(pose.x, pose.y));
    context.lineTo(x, y);
    strokeWithHalo(context, palette.halo);
    context.setLineDash([]);
  }
  context.beginPath();
  context.moveTo(x - 7, y);
  context.lineTo(x + 7, y);
  context.moveTo(x, y - 7);
  context.lineTo(x, y + 7);
  strokeWithHalo(context, palette.halo);
}

/** The chosen one first, then the largest. */
export function labelChoices(
  space: LabelSpace,
  camera: Camera,
  view: View,
  formatArea: (squareMetres: number) => string,
): void {
  const choices = [...(planOf(view.state)?.choices ?? [])];
  choices.sort((a, b) => Number(b.chosen) - Number(a.chosen) || b.gain_m2 - a.gain_m2);
  for (const choice of choices) {
    const [x, y] = camera.toScreen(...choice.at);
    const apart = radiusOf(choice) + labelGap;
    const text = `${choice.chosen ? '➜ ' : ''}${formatArea(choice.gain_m2)}`;
    space.place(text, x, [y + apart, y - apart], choice.chosen);
  }
}

// SPDX-License-Identifier: MIT
import type { Point } from '../protocol/messages';
import type { Camera } from './camera';

export type Context = CanvasRenderingContext2D;

export function tracePath(context: Context, camera: Camera, points: Iterable<Point>, closed = false): void {
  context.beginPath();
  let first = true;
  for (const [x, y] of points) {
    const [screenX, screenY] = camera.toScreen(x, y);
    if (first) context.moveTo(screenX, screenY);
    else context.lineTo(screenX, screenY);
    first = false;
  }
  if (closed) context.closePath();
}

/** Continues the path along x, y pairs. */
export function traceTrail(context: Context, camera: Camera, trail: ArrayLike<number>, connected: boolean): void {
  for (let index = 0; index + 1 < trail.length; index += 2) {
    const [x, y] = camera.toScreen(trail[index]!, trail[index + 1]!);
    if (index === 0 && !connected) context.moveTo(x, y);
    else context.lineTo(x, y);
  }
}

/** On the screen, pixels. */
export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

const labelHeight = 18;

/** Of a label around that point. */
export function labelBox(context: Context, text: string, x: number, y: number): Box {
  context.font = '600 12px system-ui, sans-serif';
  const half = context.measureText(text).width / 2 + 5;
  return { left: x - half, top: y - labelHeight / 2, right: x + half, bottom: y + labelHeight / 2 };
}

export function overlap(a: Box, b: Box): boolean {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

export function drawLabel(
  context: Context,
  text: string,
  x: number,
  y: number,
  colours: { ink: string; paper: string },
): void {
  const { left, top, right } = labelBox(context, text, x, y);
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillStyle = colours.paper;
  context.beginPath();
  context.roundRect(left, top, right - left, labelHeight, 5);
  context.fill();
  context.fillStyle = colours.ink;
  context.fillText(text, x, y + 0.5);
}

/** Stands out from any background: the halo's colour shows on both sides of the line. */
export function strokeWithHalo(context: Context, halo: string): void {
  const { strokeStyle, lineWidth } = context;
  context.strokeStyle = halo;
  context.lineWidth = lineWidth + 2.5;
  context.stroke();
  context.strokeStyle = strokeStyle;
  context.lineWidth = lineWidth;
  context.stroke();
}

export function drawArrow(
  context: Context,
  x: number,
  y: number,
  screenAngle: number,
  length: number,
  halo: string,
): void {
  const tipX = x + Math.cos(screenAngle) * length;
  const tipY = y + Math.sin(screenAngle) * length;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(tipX, tipY);
  for (const side of [-1, 1]) {
    context.moveTo(tipX, tipY);
    const barb = screenAngle + Math.PI + side * 0.5;
    context.lineTo(tipX + Math.cos(barb) * 9, tipY + Math.sin(barb) * 9);
  }
  strokeWithHalo(context, halo);
}

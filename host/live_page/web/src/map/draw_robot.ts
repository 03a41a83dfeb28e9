// SPDX-License-Identifier: MIT
import { type Hello, type Motion, PingOutcome, type Pose } from '../protocol/messages';
import type { Camera } from './camera';
import { type Context, drawLabel } from './draw_shapes';
import { ellipse95 } from './ellipse';
import type { Palette } from './palette';

const minRadiusPixels = 7;

export function drawRobot(
  context: Context,
  camera: Camera,
  pose: Pose,
  radiusM: number,
  palette: Palette,
  colour = palette.robot,
): void {
  const [x, y] = camera.toScreen(pose.x, pose.y);
  const radius = Math.max(minRadiusPixels, radiusM * camera.scale);
  context.fillStyle = colour;
  context.strokeStyle = palette.robotEdge;
  context.lineWidth = 2;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.lineWidth = 3;
  context.lineCap = 'round';
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x + Math.cos(pose.heading) * radius, y - Math.sin(pose.heading) * radius);
  context.stroke();
}

export function drawTruth(context: Context, camera: Camera, truth: Pose, radiusM: number, palette: Palette): void {
  const [x, y] = camera.toScreen(truth.x, truth.y);
  const radius = Math.max(minRadiusPixels, radiusM * camera.scale);
  context.strokeStyle = palette.truth;
  context.lineWidth = 2;
  context.setLineDash([4, 3]);
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.moveTo(x, y);
  context.lineTo(x + Math.cos(truth.heading) * radius * 1.4, y - Math.sin(truth.heading) * radius * 1.4);
  context.stroke();
  context.setLineDash([]);
}

export function drawEllipse(
  context: Context,
  camera: Camera,
  motion: Motion,
  pose: Pose,
  palette: Palette,
): void {
  const ellipse = ellipse95(motion.covariance);
  if (!ellipse) return;
  const [x, y] = camera.toScreen(pose.x, pose.y);
  context.beginPath();
  context.ellipse(x, y, ellipse.majorM * camera.scale, ellipse.minorM * camera.scale, -ellipse.angle, 0, 2 * Math.PI);
  context.globalAlpha = 0.16;
  context.fillStyle = palette.estimate;
  context.fill();
  context.globalAlpha = 1;
  context.strokeStyle = palette.estimate;
  context.lineWidth = 1.5;
  context.stroke();
}

/** Older ones are fainter. */
export function drawEchoes(context: Context, camera: Camera, echoes: readonly number[], palette: Palette): void {
  context.fillStyle = palette.echo;
  for (let index = 0; index < echoes.length; index += 2) {
    const [x, y] = camera.toScreen(echoes[index]!, echoes[index + 1]!);
    context.globalAlpha = 0.15 + (0.75 * index) / echoes.length;
    context.fillRect(x - 2, y - 2, 4, 4);
  }
  context.globalAlpha = 1;
}

/** An echo is an arc at its range, silence a dashed cone without an end, no answer a crossed-out short one. */
export function drawSonar(
  context: Context,
  camera: Camera,
  motion: Motion,
  pose: Pose,
  sonar: NonNullable<Hello['sonar']>,
  palette: Palette,
): void {
  const { ping } = motion;
  if (ping.number === 0 || ping.outcome === PingOutcome.none) return;
  const cos = Math.cos(pose.heading);
  const sin = Math.sin(pose.heading);
  const [x, y] = camera.toScreen(
    pose.x + cos * sonar.x_m - sin * sonar.y_m,
    pose.y + sin * sonar.x_m + cos * sonar.y_m,
  );
  const bearing = -(pose.heading + ping.bearing);
  const from = bearing - sonar.half_angle_rad;
  const to = bearing + sonar.half_angle_rad;
  const wedge = (rangeM: number): void => {
    context.beginPath();
    context.moveTo(x, y);
    context.arc(x, y, rangeM * camera.scale, from, to);
    context.closePath();
  };
  if (ping.outcome === PingOutcome.echo) {
    const range = ping.range ?? 0;
    wedge(range);
    context.globalAlpha = 0.22;
    context.fillStyle = palette.sonar;
    context.fill();
    context.globalAlpha = 1;
    context.strokeStyle = palette.sonar;
    context.lineWidth = 4;
    context.lineCap = 'round';
    context.beginPath();
    context.arc(x, y, range * camera.scale, from, to);
    context.stroke();
  } else if (ping.outcome === PingOutcome.silence) {
    wedge(ping.range ?? sonar.max_range_m);
    context.globalAlpha = 0.08;
    context.fillStyle = palette.silence;
    context.fill();
    context.globalAlpha = 0.9;
    context.strokeStyle = palette.silence;
    context.lineWidth = 1.5;
    context.setLineDash([2, 6]);
    context.stroke();
    context.setLineDash([]);
    context.globalAlpha = 1;
  } else {
    const length = 34;
    context.strokeStyle = palette.noAnswer;
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x + Math.cos(from) * length, y + Math.sin(from) * length);
    context.moveTo(x, y);
    context.lineTo(x + Math.cos(to) * length, y + Math.sin(to) * length);
    context.stroke();
    drawLabel(context, '?', x + Math.cos(bearing) * length, y + Math.sin(bearing) * length, {
      ink: '#ffffff',
      paper: palette.noAnswer,
    });
  }
}

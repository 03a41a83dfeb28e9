// SPDX-License-Identifier: MIT
import type { Pose } from '../protocol/messages';
import type { View } from '../run/view';
import type { Camera } from './camera';
import { drawChoices, labelChoices } from './draw_choices';
import { drawEchoes, drawEllipse, drawRobot, drawSonar, drawTruth } from './draw_robot';
import { type Context, drawArrow, drawLabel, strokeWithHalo, tracePath, traceTrail } from './draw_shapes';
import { ellipse95 } from './ellipse';
import { LabelSpace } from './label_space';
import type { Layers } from './layers';
import { type Palette, palettes, type Theme } from './palette';
import { ParticleLayer } from './particle_layer';
import { tileColours } from './tile_colours';
import { TileImages } from './tile_images';
import { drawTeam, labelTeam } from './draw_team';
import { drawSource, SourceImage } from './draw_source';
import type { ToolMarks } from './tools';

export interface MapScene {
  view: View;
  /** Of the robot, between two motions; null while it is unknown. */
  pose: Pose | null;
  layers: Layers;
  marks: ToolMarks;
  theme: Theme;
  formatMetres: (metres: number) => string;
  formatArea: (squareMetres: number) => string;
  formatPercent: (share: number) => string;
}

/** Draws the map and all that lies on it. */
export class MapPainter {
  private readonly tiles = new TileImages();
  private readonly particles = new ParticleLayer();
  private readonly sourceImage = new SourceImage();
  private colours: { key: string; table: Uint32Array } | null = null;
  private hatch: { theme: Theme; pattern: CanvasPattern } | null = null;

  draw(context: Context, camera: Camera, pixelRatio: number, scene: MapScene): void {
    const palette = palettes[scene.theme];
    context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    this.drawUnknown(context, camera, scene.theme, palette);
    const { view, layers, pose } = scene;
    const { hello } = view;
    if (!hello) return;
    const key = `${scene.theme} ${hello.step_logits} ${hello.free_below} ${hello.occupied_above}`;
    if (this.colours?.key !== key) this.colours = { key, table: tileColours(hello, palette) };
    this.tiles.update(view, this.colours.table);
    this.tiles.draw(context, camera, hello.resolution_m, pixelRatio);
    if (layers.source && view.team?.source) {
      drawSource(context, camera, view.team.source, this.sourceImage, palette);
    }
    if (layers.grid) drawGrid(context, camera, palette);
    if (layers.particles && view.particles) {
      this.particles.draw(context, camera, pixelRatio, view.particles, palette.particles);
    }
    if (layers.walls) drawWalls(context, camera, view, palette);
    drawTrails(context, camera, view, pose, layers, palette);
    if (layers.sonar) drawEchoes(context, camera, view.echoes, palette);
    if (layers.choices) drawChoices(context, camera, view, pose, palette);
    if (layers.hypotheses) drawHypotheses(context, camera, view, palette);
    const { motion } = view;
    if (motion && pose) {
      if (layers.sonar && hello.sonar) drawSonar(context, camera, motion, pose, hello.sonar, palette);
      drawEllipse(context, camera, motion, pose, palette);
      drawRobot(context, camera, pose, hello.radius_m, palette);
      if (layers.truth && motion.truth) drawTruth(context, camera, motion.truth, hello.radius_m, palette);
    }
    if (layers.team && view.team) drawTeam(context, camera, view.team, palette);
    const space = new LabelSpace(context, camera, pose, palette);
    if (layers.choices) labelChoices(space, camera, view, scene.formatArea);
    if (layers.hypotheses) labelHypotheses(space, camera, view, scene.formatPercent);
    if (layers.team && view.team) labelTeam(space, camera, view.team);
    drawMarks(context, camera, scene, palette);
  }

  private drawUnknown(context: Context, camera: Camera, theme: Theme, palette: Palette): void {
    if (this.hatch?.theme !== theme) this.hatch = { theme, pattern: hatching(context, palette) };
    context.fillStyle = this.hatch.pattern;
    context.fillRect(0, 0, camera.width, camera.height);
  }
}

function hatching(context: Context, palette: Palette): CanvasPattern {
  const edge = 10;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = edge;
  const stripes = canvas.getContext('2d')!;
  stripes.fillStyle = palette.unknown;
  stripes.fillRect(0, 0, edge, edge);
  stripes.strokeStyle = palette.hatch;
  stripes.lineWidth = 2;
  for (const shift of [-edge, 0, edge]) {
    stripes.moveTo(shift - 2, edge + 2);
    stripes.lineTo(shift + edge + 2, -2);
  }
  stripes.stroke();
  return context.createPattern(canvas, 'repeat')!;
}

/** A length of 1, 2 or 5 times a power of ten that is at least so many pixels long. */
export function roundLength(pixels: number, scale: number): number {
  const least = pixels / scale;
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((factor) => factor * power).find((length) => length >= least * 0.999) ?? power * 10;
}

function drawGrid(context: Context, camera: Camera, palette: Palette): void {
  const step = roundLength(60, camera.scale);
  const [left, top] = camera.toMap(0, 0);
  const [right, bottom] = camera.toMap(camera.width, camera.height);
  context.strokeStyle = palette.grid;
  context.lineWidth = 1;
  context.beginPath();
  for (let x = Math.ceil(left / step) * step; x <= right; x += step) {
    const at = Math.round(camera.toScreen(x, 0)[0]) + 0.5;
    context.moveTo(at, 0);
    context.lineTo(at, camera.height);
  }
  for (let y = Math.ceil(bottom / step) * step; y <= top; y += step) {
    const at = Math.round(camera.toScreen(0, y)[1]) + 0.5;
    context.moveTo(0, at);
    context.lineTo(camera.width, at);
  }
  context.stroke();
}

function drawWalls(context: Context, camera: Camera, view: View, palette: Palette): void {
  const { room } = view;
  if (!room) return;
  context.strokeStyle = palette.wall;
  context.lineJoin = context.lineCap = 'round';
  if (room.outline?.length) {
    context.lineWidth = 1.5;
    tracePath(context, camera, room.outline, true);
    context.stroke();
  }
  context.lineWidth = 3.5;
  for (const wall of room.walls ?? []) {
    tracePath(context, camera, wall);
    context.stroke();
  }
  for (const { at, radius_m } of room.cylinders ?? []) {
    const [x, y] = camera.toScreen(at[0], at[1]);
    context.beginPath();
    context.arc(x, y, radius_m * camera.scale, 0, 2 * Math.PI);
    context.stroke();
  }
}

function drawTrails(
  context: Context,
  camera: Camera,
  view: View,
  pose: Pose | null,
  layers: Layers,
  palette: Palette,
): void {
  context.lineJoin = context.lineCap = 'round';
  if (layers.odometry) {
    context.strokeStyle = palette.odometry;
    context.lineWidth = 2;
    context.setLineDash([7, 6]);
    context.beginPath();
    traceTrail(context, camera, view.odometryTrail, false);
    context.stroke();
    context.setLineDash([]);
  }
  if (layers.truth) {
    context.strokeStyle = palette.truth;
    context.lineWidth = 2;
    context.setLineDash([1, 5]);
    context.beginPath();
    traceTrail(context, camera, view.truthTrail, false);
    context.stroke();
    context.setLineDash([]);
  }
  if (layers.trail) {
    context.strokeStyle = palette.estimate;
    context.lineWidth = 2.5;
    context.beginPath();
    traceTrail(context, camera, view.trail ?? [], false);
    traceTrail(context, camera, view.trailSince, Boolean(view.trail?.length));
    if (pose && view.trailSince.length) context.lineTo(...camera.toScreen(pose.x, pose.y));
    context.stroke();
  }
}

function drawHypotheses(context: Context, camera: Camera, view: View, palette: Palette): void {
  for (const hypothesis of view.state?.localization?.hypotheses ?? []) {
    const [x, y] = camera.toScreen(hypothesis.x, hypothesis.y);
    context.strokeStyle = palette.hypothesis;
    context.lineWidth = 2;
    const ellipse = ellipse95(hypothesis);
    if (ellipse) {
      context.beginPath();
      const major = Math.max(4, ellipse.majorM * camera.scale);
      const minor = Math.max(4, ellipse.minorM * camera.scale);
      context.ellipse(x, y, major, minor, -ellipse.angle, 0, 2 * Math.PI);
      strokeWithHalo(context, palette.halo);
    }
    drawArrow(context, x, y, -hypothesis.heading, 22, palette.halo);
  }
}

/** The likeliest first; the only one needs none. */
function labelHypotheses(
  space: LabelSpace,
  camera: Camera,
  view: View,
  formatPercent: (share: number) => string,
): void {
  const hypotheses = [...(view.state?.localization?.hypotheses ?? [])];
  if (hypotheses.length < 2) return;
  hypotheses.sort((a, b) => b.probability - a.probability);
  for (const hypothesis of hypotheses) {
    const [x, y] = camera.toScreen(hypothesis.x, hypothesis.y);
    const apart = Math.max(20, (ellipse95(hypothesis)?.minorM ?? 0) * camera.scale + 10);
    space.place(formatPercent(hypothesis.probability), x, [y - apart, y + apart]);
  }
}

function drawMarks(context: Context, camera: Camera, scene: MapScene, palette: Palette): void {
  const { measure, pose } = scene.marks;
  context.strokeStyle = palette.measure;
  context.fillStyle = palette.measure;
  context.lineWidth = 2;
  tracePath(context, camera, measure);
  context.stroke();
  for (const [mapX, mapY] of measure) {
    const [x, y] = camera.toScreen(mapX, mapY);
    context.beginPath();
    context.arc(x, y, 4, 0, 2 * Math.PI);
    context.fill();
  }
  const [from, to] = measure;
  if (from && to) {
    const [x, y] = camera.toScreen((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
    drawLabel(context, scene.formatMetres(Math.hypot(to[0] - from[0], to[1] - from[1])), x, y - 14, palette);
  }
  if (pose) {
    context.strokeStyle = palette.chosen;
    context.lineWidth = 4;
    const [x, y] = camera.toScreen(pose.x, pose.y);
    drawArrow(context, x, y, -pose.heading, 44, palette.halo);
  }
}

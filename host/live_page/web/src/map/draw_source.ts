// SPDX-License-Identifier: MIT
import type { TeamField, TeamSource } from '../protocol/messages';
import type { Camera } from './camera';
import { type Context, strokeWithHalo } from './draw_shapes';
import type { Palette } from './palette';

const minRadiusPixels = 6;
const darkestAlpha = 210;

/** The probability of a source, cell by cell, as an image; drawn anew when the field changes. */
export class SourceImage {
  private made: { field: TeamField; colour: string; canvas: HTMLCanvasElement } | null = null;

  of(field: TeamField, colour: string): HTMLCanvasElement {
    if (this.made?.field !== field || this.made.colour !== colour) {
      this.made = { field, colour, canvas: drawn(field, colour) };
    }
    return this.made.canvas;
  }
}

function drawn(field: TeamField, colour: string): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  const rows = Math.ceil(field.cells.length / field.columns);
  canvas.width = field.columns;
  canvas.height = rows;
  const context = canvas.getContext('2d')!;
  const image = context.createImageData(field.columns, rows);
  const [red, green, blue] = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
  field.cells.forEach((cell, index) => {
    const row = rows - 1 - Math.floor(index / field.columns);
    const at = 4 * (row * field.columns + (index % field.columns));
    image.data.set([red!, green!, blue!, (cell / 255) * darkestAlpha], at);
  });
  context.putImageData(image, 0, 0);
  return canvas;
}

/** Where a source may be, and the circle that it is in with 95 %. */
export function drawSource(
  context: Context,
  camera: Camera,
  source: TeamSource,
  images: SourceImage,
  palette: Palette,
): void {
  const { field } = source;
  if (field && field.columns > 0 && field.cells.length > 0) {
    const canvas = images.of(field, palette.source);
    const edge = field.resolution_m * camera.scale;
    const [left, bottom] = camera.toScreen(...field.origin);
    context.imageSmoothingEnabled = false;
    context.drawImage(canvas, left, bottom - canvas.height * edge, canvas.width * edge, canvas.height * edge);
  }
  if (!source.at) return;
  const [x, y] = camera.toScreen(...source.at);
  context.strokeStyle = palette.source;
  context.lineWidth = source.verdict === 'found' ? 3.5 : 1.5;
  context.setLineDash(source.verdict === 'found' ? [] : [4, 4]);
  context.beginPath();
  context.arc(x, y, Math.max(minRadiusPixels, source.radius_m * camera.scale), 0, 2 * Math.PI);
  strokeWithHalo(context, palette.halo);
  context.setLineDash([]);
}

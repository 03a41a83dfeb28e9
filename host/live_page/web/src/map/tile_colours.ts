// SPDX-License-Identifier: MIT
import type { Palette } from './palette';

export interface OccupancyScale {
  step_logits: number;
  free_below: number;
  occupied_above: number;
}

const noEvidence = 0;
const evenOdds = 128;

export function occupancyProbability(cell: number, stepLogits: number): number {
  return 1 / (1 + Math.exp(-(cell - evenOdds) * stepLogits));
}

/** For each value of a cell its RGBA as ImageData holds it. No evidence is transparent: the hatching shows. */
export function tileColours(scale: OccupancyScale, palette: Palette): Uint32Array {
  const rgba = new Uint8ClampedArray(256 * 4);
  for (let cell = 0; cell < 256; ++cell) {
    if (cell === noEvidence) continue;
    const probability = occupancyProbability(cell, scale.step_logits);
    rgba.set(colourOf(probability, scale, palette), cell * 4);
    rgba[cell * 4 + 3] = 255;
  }
  return new Uint32Array(rgba.buffer);
}

function colourOf(probability: number, scale: OccupancyScale, palette: Palette): readonly number[] {
  if (probability < scale.free_below) return palette.free;
  if (probability > scale.occupied_above) return palette.occupied;
  const share = Math.min(1, (probability - scale.free_below) / (0.5 - scale.free_below));
  return palette.free.map((free, channel) => free + (palette.undecided[channel]! - free) * share);
}

// SPDX-License-Identifier: MIT
import type { Particles } from '../protocol/messages';
import type { Camera } from './camera';
import type { Context } from './draw_shapes';

/** Particles by the colour of their weight, light ones first. */
interface Sorted {
  particles: Particles;
  order: Uint32Array;
  /** Of each colour the end in `order`. */
  ends: Uint32Array;
}

let sorted: Sorted | null = null;

export function drawParticles(
  context: Context,
  camera: Camera,
  particles: Particles,
  colours: readonly string[],
): void {
  if (sorted?.particles !== particles) sorted = sortByWeight(particles, colours.length);
  const size = Math.min(5, Math.max(2, camera.scale * 0.015));
  const halfWidth = camera.width / 2;
  const halfHeight = camera.height / 2;
  let next = 0;
  for (let colour = 0; colour < colours.length; ++colour) {
    context.fillStyle = colours[colour]!;
    for (const end = sorted.ends[colour]!; next < end; ++next) {
      const at = sorted.order[next]! * 4;
      const x = halfWidth + (particles[at]! - camera.x) * camera.scale;
      const y = halfHeight - (particles[at + 1]! - camera.y) * camera.scale;
      if (x < 0 || y < 0 || x > camera.width || y > camera.height) continue;
      context.fillRect(x - size / 2, y - size / 2, size, size);
    }
  }
}

function sortByWeight(particles: Particles, colours: number): Sorted {
  const count = particles.length >> 2;
  let heaviest = 0;
  for (let index = 0; index < count; ++index) heaviest = Math.max(heaviest, particles[index * 4 + 3]!);
  const colourOf = (index: number): number =>
    heaviest > 0 ? Math.min(colours - 1, Math.floor((particles[index * 4 + 3]! / heaviest) * colours)) : 0;
  const ends = new Uint32Array(colours);
  for (let index = 0; index < count; ++index) ends[colourOf(index)]! += 1;
  for (let colour = 1; colour < colours; ++colour) ends[colour]! += ends[colour - 1]!;
  const order = new Uint32Array(count);
  const place = ends.slice();
  for (let index = count - 1; index >= 0; --index) order[--place[colourOf(index)]!] = index;
  return { particles, order, ends };
}

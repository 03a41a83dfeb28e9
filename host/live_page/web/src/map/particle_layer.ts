// SPDX-License-Identifier: MIT
import type { Particles } from '../protocol/messages';
import type { Camera } from './camera';
import type { Context } from './draw_shapes';

/** Particles as an image of their own: drawn anew only where they or the camera have changed. */
export class ParticleLayer {
  private readonly context = document.createElement('canvas').getContext('2d')!;
  private image = new ImageData(1, 1);
  private pixels = new Uint32Array();
  private particles: Particles | null = null;
  private colours: readonly string[] = [];
  private order = new Uint32Array();
  /** Of each colour the end in `order`. */
  private ends = new Uint32Array();
  private key = '';

  draw(
    target: Context,
    camera: Camera,
    pixelRatio: number,
    particles: Particles,
    colours: readonly string[],
  ): void {
    const { width, height } = target.canvas;
    const key = [camera.x, camera.y, camera.scale, width, height].join();
    const isNew = particles !== this.particles || colours !== this.colours;
    if (isNew) this.sortByWeight(particles, colours);
    if (isNew || key !== this.key) {
      this.key = key;
      this.clear(width, height);
      this.paint(camera, pixelRatio, particles);
      this.context.putImageData(this.image, 0, 0);
    }
    target.drawImage(this.context.canvas, 0, 0, camera.width, camera.height);
  }

  private clear(width: number, height: number): void {
    if (this.image.width === width && this.image.height === height) {
      this.pixels.fill(0);
      return;
    }
    this.context.canvas.width = width;
    this.context.canvas.height = height;
    this.image = new ImageData(width, height);
    this.pixels = new Uint32Array(this.image.data.buffer);
  }

  private paint(camera: Camera, pixelRatio: number, particles: Particles): void {
    const { pixels } = this;
    const { width, height } = this.image;
    const scale = camera.scale * pixelRatio;
    const size = Math.round(Math.min(5, Math.max(2, camera.scale * 0.015)) * pixelRatio);
    const left = width / 2 - camera.x * scale - size / 2;
    const top = height / 2 + camera.y * scale - size / 2;
    let next = 0;
    for (let colour = 0; colour < this.colours.length; ++colour) {
      const value = pixelOf(this.colours[colour]!);
      for (const end = this.ends[colour]!; next < end; ++next) {
        const at = this.order[next]! * 4;
        const x = Math.round(left + particles[at]! * scale);
        const y = Math.round(top - particles[at + 1]! * scale);
        if (!(x >= 0 && y >= 0 && x + size <= width && y + size <= height)) continue;
        for (let row = y; row < y + size; ++row) pixels.fill(value, row * width + x, row * width + x + size);
      }
    }
  }

  /** Light ones first, so that heavy ones lie above them. */
  private sortByWeight(particles: Particles, colours: readonly string[]): void {
    this.particles = particles;
    this.colours = colours;
    const count = particles.length >> 2;
    let heaviest = 0;
    for (let index = 0; index < count; ++index) heaviest = Math.max(heaviest, particles[index * 4 + 3]!);
    const colourOf = (index: number): number =>
      heaviest > 0
        ? Math.min(colours.length - 1, Math.floor((particles[index * 4 + 3]! / heaviest) * colours.length))
        : 0;
    this.ends = new Uint32Array(colours.length);
    for (let index = 0; index < count; ++index) this.ends[colourOf(index)]! += 1;
    for (let colour = 1; colour < colours.length; ++colour) this.ends[colour]! += this.ends[colour - 1]!;
    this.order = new Uint32Array(count);
    const place = this.ends.slice();
    for (let index = count - 1; index >= 0; --index) this.order[--place[colourOf(index)]!] = index;
  }
}

/** Of #rrggbb, as ImageData holds it. */
function pixelOf(colour: string): number {
  const [red, green, blue] = [1, 3, 5].map((from) => parseInt(colour.slice(from, from + 2), 16));
  return new Uint32Array(Uint8Array.of(red!, green!, blue!, 255).buffer)[0]!;
}

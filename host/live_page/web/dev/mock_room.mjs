// SPDX-License-Identifier: MIT
// A room with two pillars, and a map of it that grows as a robot sees it.

const evenOdds = 128;
const maxEvidence = 100;

export class MockRoom {
  /** `cells` by `cells` of them; the room fills most of that square. */
  constructor(cells, resolution) {
    this.resolution = resolution;
    this.size = cells * resolution;
    const edge = this.size * 0.46;
    this.outline = [
      [-edge, -edge],
      [edge, -edge],
      [edge, edge * 0.3],
      [edge * 0.4, edge * 0.3],
      [edge * 0.4, edge],
      [-edge, edge],
    ];
    this.pillars = [
      { at: [edge * 0.45, -edge * 0.35], radius_m: edge * 0.08 },
      { at: [-edge * 0.5, edge * 0.45], radius_m: edge * 0.1 },
    ];
    this.tiles = new Map();
    this.dirty = new Set();
  }

  clear() {
    this.tiles.clear();
    this.dirty.clear();
  }

  /** Distance to the first wall along a bearing. */
  range(x, y, bearing) {
    const dx = Math.cos(bearing);
    const dy = Math.sin(bearing);
    let nearest = Infinity;
    this.outline.forEach((from, index) => {
      const to = this.outline[(index + 1) % this.outline.length];
      const ex = to[0] - from[0];
      const ey = to[1] - from[1];
      const cross = dx * ey - dy * ex;
      if (Math.abs(cross) < 1e-9) return;
      const along = ((from[0] - x) * ey - (from[1] - y) * ex) / cross;
      const share = ((from[0] - x) * dy - (from[1] - y) * dx) / cross;
      if (along > 0 && share >= 0 && share <= 1) nearest = Math.min(nearest, along);
    });
    for (const { at, radius_m } of this.pillars) {
      const b = dx * (x - at[0]) + dy * (y - at[1]);
      const c = (x - at[0]) ** 2 + (y - at[1]) ** 2 - radius_m ** 2;
      if (b * b > c && -b - Math.sqrt(b * b - c) > 0) nearest = Math.min(nearest, -b - Math.sqrt(b * b - c));
    }
    return nearest;
  }

  /** Marks a ray free, and its end occupied where it is an echo. */
  addRay(x, y, bearing, maxRange) {
    const range = this.range(x, y, bearing);
    const end = Math.min(range, maxRange);
    for (let along = 0; along < end; along += this.resolution * 0.7) {
      this.add(x + Math.cos(bearing) * along, y + Math.sin(bearing) * along, -6);
    }
    if (range > maxRange) return null;
    this.add(x + Math.cos(bearing) * range, y + Math.sin(bearing) * range, 14);
    return range;
  }

  add(x, y, evidence) {
    const i = Math.floor(x / this.resolution);
    const j = Math.floor(y / this.resolution);
    const tileX = Math.floor(i / 64);
    const tileY = Math.floor(j / 64);
    const key = `${tileX},${tileY}`;
    let tile = this.tiles.get(key);
    if (!tile) this.tiles.set(key, (tile = { x: tileX, y: tileY, cells: new Uint8Array(64 * 64) }));
    const cell = (j - tileY * 64) * 64 + (i - tileX * 64);
    const before = tile.cells[cell] || evenOdds;
    tile.cells[cell] = Math.max(evenOdds - maxEvidence, Math.min(evenOdds + maxEvidence, before + evidence));
    this.dirty.add(tile);
  }

  /** The whole map at once, for measurements. */
  fill() {
    const half = this.size / 2;
    for (let x = -half; x < half; x += this.resolution) {
      for (let y = -half; y < half; y += this.resolution) {
        const isInside = Math.abs(x) < half * 0.92 && Math.abs(y) < half * 0.92;
        this.add(x + 1e-6, y + 1e-6, isInside ? (Math.hypot(x % 1, y % 1) < 0.15 ? 60 : -60) : 60);
      }
    }
  }
}

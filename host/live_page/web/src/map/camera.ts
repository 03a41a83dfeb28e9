// SPDX-License-Identifier: MIT
import type { Point } from '../protocol/messages';

export interface Bounds {
  minX: number;
  minY: number;
  maxX: number;
  maxY: number;
}

const minScale = 4;
const maxScale = 2000;
const fitMargin = 1.1;

/** What part of the map is shown: y upwards in the map, downwards on the screen. */
export class Camera {
  /** Metres, at the middle of the screen. */
  x = 0;
  y = 0;
  /** Pixels of the page for a metre. */
  scale = 80;
  width = 1;
  height = 1;

  toScreen(x: number, y: number): Point {
    return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale];
  }

  toMap(screenX: number, screenY: number): Point {
    return [
      this.x + (screenX - this.width / 2) / this.scale,
      this.y - (screenY - this.height / 2) / this.scale,
    ];
  }

  fit(bounds: Bounds): void {
    const width = Math.max(0.5, bounds.maxX - bounds.minX);
    const height = Math.max(0.5, bounds.maxY - bounds.minY);
    this.x = (bounds.minX + bounds.maxX) / 2;
    this.y = (bounds.minY + bounds.maxY) / 2;
    this.scale = clampScale(Math.min(this.width / width, this.height / height) / fitMargin);
  }

  panBy(screenX: number, screenY: number): void {
    this.x -= screenX / this.scale;
    this.y += screenY / this.scale;
  }

  /** Keeps the map's point below the screen's point. */
  zoomAt(screenX: number, screenY: number, factor: number): void {
    this.place(this.toMap(screenX, screenY), screenX, screenY, this.scale * factor);
  }

  /** Shows the map's point at the screen's point, at that scale. */
  place(point: Point, screenX: number, screenY: number, scale: number): void {
    this.scale = clampScale(scale);
    this.x = point[0] - (screenX - this.width / 2) / this.scale;
    this.y = point[1] + (screenY - this.height / 2) / this.scale;
  }
}

function clampScale(scale: number): number {
  return Math.min(maxScale, Math.max(minScale, scale));
}

// SPDX-License-Identifier: MIT
import { tileCells, type Tile } from '../protocol/messages';
import type { View } from '../run/view';
import type { Camera } from './camera';

/** 8 x 8 tiles in a canvas of 512 x 512: few to draw, and far below what browsers allow. */
const tilesPerChunk = 8;
const chunkCells = tilesPerChunk * tileCells;

interface Chunk {
  x: number;
  y: number;
  context: CanvasRenderingContext2D;
}

/** Raster images of the map; only tiles that have changed are coloured anew. */
export class TileImages {
  private chunks = new Map<string, Chunk>();
  private shown = new Map<string, Tile>();
  private shownVersion = -1;
  private colours: Uint32Array | null = null;
  private readonly image = new ImageData(tileCells, tileCells);
  private readonly pixels = new Uint32Array(this.image.data.buffer);

  update(view: View, colours: Uint32Array): void {
    if (colours !== this.colours) {
      this.colours = colours;
      this.shown.clear();
      this.shownVersion = -1;
    }
    if (view.tilesVersion === this.shownVersion) return;
    this.shownVersion = view.tilesVersion;
    for (const [key, tile] of this.shown) {
      if (view.tiles.has(key)) continue;
      this.shown.delete(key);
      const [left, top] = placeInChunk(tile);
      this.chunkOf(tile).context.clearRect(left, top, tileCells, tileCells);
    }
    for (const [key, tile] of view.tiles) {
      if (this.shown.get(key) === tile) continue;
      this.shown.set(key, tile);
      this.colour(tile, colours);
    }
  }

  draw(context: CanvasRenderingContext2D, camera: Camera, resolution: number, pixelRatio: number): void {
    const cellPixels = resolution * camera.scale * pixelRatio;
    context.imageSmoothingEnabled = cellPixels < 1;
    const edge = chunkCells * resolution;
    for (const chunk of this.chunks.values()) {
      const [left, bottom] = camera.toScreen(chunk.x * edge, chunk.y * edge);
      const [right, top] = camera.toScreen((chunk.x + 1) * edge, (chunk.y + 1) * edge);
      if (right < 0 || bottom < 0 || left > camera.width || top > camera.height) continue;
      const snap = (length: number): number => Math.round(length * pixelRatio) / pixelRatio;
      const x = snap(left);
      const y = snap(top);
      context.drawImage(chunk.context.canvas, x, y, snap(right) - x, snap(bottom) - y);
    }
  }

  private colour(tile: Tile, colours: Uint32Array): void {
    for (let row = 0; row < tileCells; ++row) {
      const from = (tileCells - 1 - row) * tileCells;
      const to = row * tileCells;
      for (let column = 0; column < tileCells; ++column) {
        this.pixels[to + column] = colours[tile.cells[from + column]!]!;
      }
    }
    const [left, top] = placeInChunk(tile);
    this.chunkOf(tile).context.putImageData(this.image, left, top);
  }

  private chunkOf(tile: Tile): Chunk {
    const x = Math.floor(tile.x / tilesPerChunk);
    const y = Math.floor(tile.y / tilesPerChunk);
    const key = `${x},${y}`;
    let chunk = this.chunks.get(key);
    if (!chunk) {
      const canvas = document.createElement('canvas');
      canvas.width = canvas.height = chunkCells;
      chunk = { x, y, context: canvas.getContext('2d')! };
      this.chunks.set(key, chunk);
    }
    return chunk;
  }
}

/** Left and top edge; the rows of a chunk run downwards. */
function placeInChunk(tile: Tile): [number, number] {
  const column = tile.x - Math.floor(tile.x / tilesPerChunk) * tilesPerChunk;
  const row = tile.y - Math.floor(tile.y / tilesPerChunk) * tilesPerChunk;
  return [column * tileCells, (tilesPerChunk - 1 - row) * tileCells];
}

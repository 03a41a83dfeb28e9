// SPDX-License-Identifier: MIT
import { tileCells, type Tile } from '../protocol/messages';
import type { View } from '../run/view';
import type { Bounds } from './camera';

/** Around a robot that knows no more than where it stands. */
const blankRadiusM = 1.5;
const seenOfTile = new WeakMap<Tile, Bounds | 'nothing'>();

/** In cells of the map; where the tile holds no evidence: 'nothing'. */
function seenCells(tile: Tile): Bounds | 'nothing' {
  const known = seenOfTile.get(tile);
  if (known) return known;
  let minX = tileCells;
  let minY = tileCells;
  let maxX = -1;
  let maxY = -1;
  for (let index = 0; index < tile.cells.length; ++index) {
    if (tile.cells[index] === 0) continue;
    const x = index % tileCells;
    const y = (index - x) / tileCells;
    minX = Math.min(minX, x);
    maxX = Math.max(maxX, x);
    minY = Math.min(minY, y);
    maxY = Math.max(maxY, y);
  }
  const left = tile.x * tileCells;
  const bottom = tile.y * tileCells;
  const seen: Bounds | 'nothing' =
    maxX < 0
      ? 'nothing'
      : { minX: left + minX, minY: bottom + minY, maxX: left + maxX + 1, maxY: bottom + maxY + 1 };
  seenOfTile.set(tile, seen);
  return seen;
}

/** Of all that the map shows, metres; null while there is nothing. */
export function mapBounds(view: View): Bounds | null {
  const resolution = view.hello?.resolution_m ?? 0;
  const bounds: Bounds = { minX: Infinity, minY: Infinity, maxX: -Infinity, maxY: -Infinity };
  const add = (minX: number, minY: number, maxX: number, maxY: number): void => {
    bounds.minX = Math.min(bounds.minX, minX);
    bounds.minY = Math.min(bounds.minY, minY);
    bounds.maxX = Math.max(bounds.maxX, maxX);
    bounds.maxY = Math.max(bounds.maxY, maxY);
  };
  for (const tile of view.tiles.values()) {
    const seen = seenCells(tile);
    if (seen === 'nothing') continue;
    add(seen.minX * resolution, seen.minY * resolution, seen.maxX * resolution, seen.maxY * resolution);
  }
  const isBlank = !(bounds.maxX - bounds.minX > blankRadiusM);
  const pose = view.motion?.pose;
  if (pose && Number.isFinite(pose.x + pose.y)) {
    const radius = isBlank ? blankRadiusM : (view.hello?.radius_m ?? 0);
    add(pose.x - radius, pose.y - radius, pose.x + radius, pose.y + radius);
  }
  for (const robot of view.team?.robots ?? []) {
    if (robot.pose) add(robot.pose.x - blankRadiusM, robot.pose.y - blankRadiusM, robot.pose.x + blankRadiusM, robot.pose.y + blankRadiusM);
  }
  // Once there is a map they stray too far from it to count.
  for (let index = 0; isBlank && index < view.echoes.length; index += 2) {
    const x = view.echoes[index]!;
    const y = view.echoes[index + 1]!;
    add(x, y, x, y);
  }
  for (const [x, y] of view.room?.outline ?? []) add(x, y, x, y);
  return bounds.minX < bounds.maxX ? bounds : null;
}

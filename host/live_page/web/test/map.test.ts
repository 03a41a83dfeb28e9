// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { Camera } from '../src/map/camera';
import { roundLength } from '../src/map/draw_map';
import { ellipse95 } from '../src/map/ellipse';
import { mapBounds } from '../src/map/map_bounds';
import { palettes } from '../src/map/palette';
import { ShownPose } from '../src/map/shown_pose';
import { occupancyProbability, tileColours } from '../src/map/tile_colours';
import { decode } from '../src/protocol/decode';
import { apply, emptyView } from '../src/run/view';
import { encode, motion } from './messages';

describe('ellipse95', () => {
  it('has the 95 % radius along each axis', () => {
    const ellipse = ellipse95({ xx: 0.04, xy: 0, yy: 0.01 })!;
    expect(ellipse.majorM).toBeCloseTo(Math.sqrt(5.991 * 0.04));
    expect(ellipse.minorM).toBeCloseTo(Math.sqrt(5.991 * 0.01));
    expect(ellipse.angle).toBeCloseTo(0);
  });

  it('turns with the covariance', () => {
    expect(ellipse95({ xx: 1, xy: 0.5, yy: 1 })!.angle).toBeCloseTo(Math.PI / 4);
    expect(ellipse95({ xx: 1, xy: 0, yy: 2 })!.angle).toBeCloseTo(Math.PI / 2);
  });

  it('is none where the position is unsure', () => {
    expect(ellipse95(null)).toBeNull();
    expect(ellipse95({ xx: NaN, xy: 0, yy: 1 })).toBeNull();
  });
});

describe('tileColours', () => {
  const scale = { step_logits: 0.05, free_below: 0.196, occupied_above: 0.65 };
  const channels = (colours: Uint32Array, cell: number): number[] => [
    ...new Uint8Array(colours.buffer, cell * 4, 4),
  ];

  it.each(['light', 'dark'] as const)('tells free, undecided, occupied and unseen apart: %s', (theme) => {
    const palette = palettes[theme];
    const colours = tileColours(scale, palette);
    expect(channels(colours, 0)[3]).toBe(0);
    expect(channels(colours, 28)).toEqual([...palette.free, 255]);
    expect(channels(colours, 128)).toEqual([...palette.undecided, 255]);
    expect(channels(colours, 228)).toEqual([...palette.occupied, 255]);
    expect(palette.free[0]).toBeGreaterThan(palette.undecided[0]);
    expect(palette.undecided[0]).toBeGreaterThan(palette.occupied[0]);
  });

  it('switches at the thresholds', () => {
    const colours = tileColours(scale, palettes.light);
    for (let cell = 1; cell < 256; ++cell) {
      const probability = occupancyProbability(cell, scale.step_logits);
      const isOccupied = channels(colours, cell)[0] === palettes.light.occupied[0];
      expect(isOccupied, `cell ${cell}`).toBe(probability > scale.occupied_above);
    }
  });
});

describe('Camera', () => {
  it('keeps the point below the pointer', () => {
    const camera = new Camera();
    camera.width = 800;
    camera.height = 600;
    const before = camera.toMap(100, 200);
    camera.zoomAt(100, 200, 3);
    const after = camera.toMap(100, 200);
    expect(after[0]).toBeCloseTo(before[0]);
    expect(after[1]).toBeCloseTo(before[1]);
  });

  it('fits a room with a margin', () => {
    const camera = new Camera();
    camera.width = 400;
    camera.height = 800;
    camera.fit({ minX: -2, minY: 0, maxX: 2, maxY: 1 });
    expect(camera.toScreen(-2, 0)[0]).toBeGreaterThan(0);
    expect(camera.toScreen(2, 1)[0]).toBeLessThan(400);
    expect(camera.toMap(200, 400)[1]).toBeCloseTo(0.5);
  });
});

describe('mapBounds', () => {
  it('spans the cells that have been seen', () => {
    const cells = new Uint8Array(64 * 64);
    cells[2 * 64 + 3] = 100;
    cells[5 * 64 + 10] = 200;
    const view = emptyView();
    for (const bytes of [encode.hello(0, { resolution_m: 0.1 }), encode.tile(0, -1, 0, cells)]) apply(view, decode(bytes)!);
    const bounds = mapBounds(view)!;
    expect(bounds.minX).toBeCloseTo(-6.1);
    expect(bounds.maxX).toBeCloseTo(-5.3);
    expect(bounds.minY).toBeCloseTo(0.2);
    expect(bounds.maxY).toBeCloseTo(0.6);
  });

  it('spans the echoes while there is no map', () => {
    const view = emptyView();
    const hello = encode.hello(0, { sonar: { x_m: 0, y_m: 0, half_angle_rad: 0.2, max_range_m: 4 } });
    const ping = motion(0, { pose: [0, 0, 0], ping: { bearing: 0, range: 3, number: 1, outcome: 1 } });
    for (const bytes of [hello, ping]) apply(view, decode(bytes)!);
    expect(mapBounds(view)!.maxX).toBeCloseTo(3);
    expect(mapBounds(view)!.minX).toBeCloseTo(-1.5);
  });

  it('is none before anything was seen', () => {
    expect(mapBounds(emptyView())).toBeNull();
  });
});

describe('roundLength', () => {
  it.each([
    [44, 100, 0.5],
    [44, 22, 2],
    [44, 1, 50],
    [44, 44, 1],
  ])('at least %i pixels at %i pixels a metre: %f m', (pixels, scale, length) => {
    expect(roundLength(pixels, scale)).toBeCloseTo(length);
  });
});

describe('ShownPose', () => {
  const motionAt = (x: number) => {
    const message = decode(motion(1, { pose: [x, 0, 0] }));
    return message?.kind === 'motion' ? message.motion : null;
  };

  it('glides to a motion that is near, and jumps to one that is far', () => {
    const shown = new ShownPose();
    expect(shown.at(motionAt(0), 0)?.x).toBe(0);
    const near = motionAt(0.1);
    expect(shown.at(near, 100)?.x).toBeCloseTo(0);
    expect(shown.at(near, 130)?.x).toBeCloseTo(0.05);
    expect(shown.at(near, 200)?.x).toBeCloseTo(0.1);
    expect(shown.at(motionAt(5), 300)?.x).toBe(5);
    expect(shown.at(null, 400)).toBeNull();
  });
});

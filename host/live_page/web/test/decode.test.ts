// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { decode } from '../src/protocol/decode';
import { encode, motion, state, tile } from './messages';

const everyKind: Record<string, Uint8Array> = {
  hello: encode.hello(0, { run: '0', robot: 'uno_2wd' }),
  tile: tile(1, -2, 3, 130),
  motion: motion(2),
  particles: encode.particles(3, [1, 2, 3, 0.25, 4, 5, 6, 0.75]),
  trail: encode.trail(4, [0, 0, 1, 2]),
  room: encode.room(5, { walls: [], outline: [[0, 0]] }),
  state: state(6, 'explore'),
  event: encode.event(7, { code: 'kidnapped', level: 'warning', text: 'carried off' }),
  newMap: encode.newMap(8),
  team: encode.team(9, { robots: [], source: null }),
};

describe('decode', () => {
  it.each(Object.entries(everyKind))('reads %s with its time', (kind, bytes) => {
    const message = decode(bytes);
    expect(message?.kind).toBe(kind);
    expect(message?.time).toBe(Object.keys(everyKind).indexOf(kind));
  });

  it.each(Object.entries(everyKind))('ignores %s that is cut off anywhere', (kind, bytes) => {
    for (let length = 0; length < bytes.length; length += bytes.length > 500 ? 97 : 1) {
      expect(decode(bytes.subarray(0, length)), `${kind} of ${length} bytes`).toBeNull();
    }
  });

  it('reads at any alignment', () => {
    for (const bytes of Object.values(everyKind)) {
      const shifted = new Uint8Array(bytes.length + 3);
      shifted.set(bytes, 3);
      expect(decode(shifted.subarray(3))).toEqual(decode(new Uint8Array(bytes)));
    }
  });

  it('reads a tile by its place and cells', () => {
    const message = decode(everyKind.tile!);
    expect(message).toMatchObject({ tile: { x: -2, y: 3 } });
    expect(message?.kind === 'tile' && message.tile.cells.every((cell) => cell === 130)).toBe(true);
  });

  it('reads all of a motion', () => {
    const message = decode(motion(2, { pose: [1, 2, 0.5], truth: [1.5, 2.5, 0.75] }));
    expect(message?.kind === 'motion' && message.motion).toMatchObject({
      clockMs: 2000,
      pose: { x: 1, y: 2, heading: 0.5 },
      odometry: { x: 2, y: 2.5, heading: 0.25 },
      truth: { x: 1.5, y: 2.5, heading: 0.75 },
      ping: { bearing: 0.25, range: 1.5, number: 7, outcome: 1 },
    });
  });

  it('has null where a motion has no number', () => {
    const message = decode(
      motion(2, {
        covariance: [NaN, NaN, NaN],
        headingStddev: NaN,
        ping: { bearing: 0, range: NaN, number: 8, outcome: 2 },
      }),
    );
    expect(message?.kind === 'motion' && message.motion).toMatchObject({
      covariance: null,
      headingStddev: null,
      truth: null,
      ping: { range: null, outcome: 2 },
    });
  });

  it('reads particles and trails', () => {
    const particles = decode(everyKind.particles!);
    expect(particles?.kind === 'particles' && [...particles.particles]).toEqual([1, 2, 3, 0.25, 4, 5, 6, 0.75]);
    const trail = decode(everyKind.trail!);
    expect(trail?.kind === 'trail' && [...trail.trail]).toEqual([0, 0, 1, 2]);
  });

  it('ignores what it does not know', () => {
    const unknown = encode.newMap(1);
    unknown[0] = 77;
    expect(decode(unknown)).toBeNull();
    const list = encode.state(1, []);
    expect(decode(list)).toBeNull();
    const count = encode.particles(1, []);
    count.set([255, 255, 255, 255], 16);
    expect(decode(count)).toBeNull();
  });
});

// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { decode } from '../src/protocol/decode';
import { apply, emptyView, type View, wrapAngle } from '../src/run/view';
import { encode, motion, tile } from './messages';

function viewAfter(...messages: Uint8Array[]): View {
  const view = emptyView();
  for (const bytes of messages) apply(view, decode(bytes)!);
  return view;
}

describe('apply', () => {
  it('replaces a tile, and adds another', () => {
    const view = viewAfter(tile(0, 0, 0, 9), tile(1, 0, 0, 11), tile(2, -1, 0, 12));
    expect(view.tiles.size).toBe(2);
    expect(view.tiles.get('0,0')?.cells[0]).toBe(11);
  });

  it('adds poses behind the trail until a trail replaces them', () => {
    const before = viewAfter(motion(1), motion(2));
    expect(before.trailSince).toEqual([1, 2, 2, 2]);
    const after = viewAfter(motion(1), motion(2), encode.trail(2, [0, 0, 2, 2]), motion(3));
    expect([...after.trail!]).toEqual([0, 0, 2, 2]);
    expect(after.trailSince).toEqual([3, 2]);
    expect(after.odometryTrail).toEqual([1, 2.5, 2, 2.5, 3, 2.5]);
  });

  it('keeps the newest of a fleet', () => {
    const team = (stops: number) => ({ robots: [{ name: 'robot0', stops }], source: null });
    expect(viewAfter().team).toBeNull();
    expect(viewAfter(encode.team(1, team(1)), encode.team(2, team(2))).team).toEqual(team(2));
  });

  it('forgets what a new map makes void, and keeps events', () => {
    const event = encode.event(1, { code: 'kidnapped', level: 'warning', text: '' });
    const view = viewAfter(tile(0, 0, 0, 9), motion(1), encode.particles(1, [0, 0, 0, 1]), event, encode.newMap(2));
    expect(view.tiles.size).toBe(0);
    expect(view.particles).toBeNull();
    expect(view.trailSince).toEqual([]);
    expect(view.odometryTrail).toEqual([]);
    expect(view.events).toHaveLength(1);
  });

  it('puts each ping with an echo where its beam points, and keeps the newest', () => {
    const hello = encode.hello(0, { sonar: { x_m: 0.1, y_m: 0, half_angle_rad: 0.2, max_range_m: 4 } });
    const ping = (number: number, changes: object = {}) =>
      motion(number, {
        pose: [1, 2, Math.PI / 2],
        ping: { bearing: -Math.PI / 2, range: 1.5, number, outcome: 1, ...changes },
      });
    const view = viewAfter(hello, ping(1), ping(1), ping(2, { range: NaN, outcome: 2 }), ping(3, { outcome: 3 }));
    expect(view.echoes).toHaveLength(2);
    expect(view.echoes[0]).toBeCloseTo(2.5);
    expect(view.echoes[1]).toBeCloseTo(2.1);
    for (let number = 4; number < 600; ++number) apply(view, decode(ping(number))!);
    expect(view.echoes).toHaveLength(800);
    apply(view, decode(motion(600, { pose: [5, 5, 0], ping: { bearing: 0, range: 1, number: 600, outcome: 1 } }))!);
    expect(view.echoes).toHaveLength(2);
  });

  it('compares odometry and estimate once a second', () => {
    const view = viewAfter(...Array.from({ length: 31 }, (_, step) => motion(step / 10)));
    expect(view.series.time).toEqual([0, 1, 2, 3]);
    expect(view.series.distanceM[1]).toBeCloseTo(0.5);
    expect(view.series.headingRad[1]).toBeCloseTo(0.25);
  });
});

describe('wrapAngle', () => {
  it('stays between -pi and pi', () => {
    expect(wrapAngle(3 * Math.PI - 0.1)).toBeCloseTo(Math.PI - 0.1);
    expect(wrapAngle(-7)).toBeCloseTo(2 * Math.PI - 7);
  });
});

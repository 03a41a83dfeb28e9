// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { decode } from '../src/protocol/decode';
import { joinHistory, splitHistory, Timeline } from '../src/run/timeline';
import { apply, emptyView, type View } from '../src/run/view';
import { encode, motion, state, tile } from './messages';

function longRun(): Uint8Array[] {
  const messages = [encode.hello(0, { run: '0', resolution_m: 0.05 })];
  for (let step = 1; step <= 1500; ++step) {
    const time = step / 10;
    if (step % 7 === 0) messages.push(tile(time, step % 5, step % 3, 1 + (step % 250)));
    if (step % 50 === 0) messages.push(encode.event(time, { code: 'loop-closed', level: 'info', text: `${step}` }));
    if (step % 90 === 0) messages.push(encode.trail(time, [0, 0, time, 2]));
    if (step === 800) messages.push(encode.newMap(time));
    if (step % 10 === 0) messages.push(encode.particles(time, [time, 0, 0, 1]), state(time, 'explore'));
    messages.push(motion(time));
  }
  return messages;
}

function sequentially(messages: Uint8Array[], until: number): View {
  const view = emptyView();
  for (const bytes of messages) {
    const message = decode(bytes)!;
    if (message.time <= until) apply(view, message);
  }
  return view;
}

const withoutVersion = (view: View): object => ({ ...view, tilesVersion: 0 });

describe('Timeline', () => {
  const messages = longRun();
  const timeline = new Timeline();
  for (const bytes of messages) timeline.append(bytes);

  it.each([0, 0.1, 33.3, 79.9, 80, 80.1, 120, 150, 999])('shows at %f s what applying in order shows', (time) => {
    expect(withoutVersion(timeline.seek(time).view)).toEqual(withoutVersion(sequentially(messages, time)));
  });

  it('shows the same wherever the cursor comes from', () => {
    let cursor = timeline.seek(10);
    for (const time of [11, 60, 59, 140, 3, 3, 150, 0]) {
      cursor = timeline.seek(time, cursor);
      expect(withoutVersion(cursor.view)).toEqual(withoutVersion(sequentially(messages, time)));
    }
  });

  it('leaves the newest view as it is', () => {
    timeline.seek(20);
    expect(withoutVersion(timeline.head)).toEqual(withoutVersion(sequentially(messages, 999)));
  });

  it('keeps ten motions and one set of particles a second, and shows each', () => {
    const dense = new Timeline();
    for (let step = 0; step < 200; ++step) {
      dense.append(motion(step / 20));
      dense.append(encode.particles(step / 20, [step, 0, 0, 1]));
    }
    expect(dense.length).toBeGreaterThanOrEqual(100);
    expect(dense.length).toBeLessThanOrEqual(115);
    expect(dense.head.particles?.[0]).toBe(199);
  });

  it('ignores what says nothing', () => {
    const short = new Timeline();
    expect(short.append(new Uint8Array(5))).toBeNull();
    expect(short.length).toBe(0);
    expect(short.seek(3).view.hello).toBeNull();
  });
});

describe('joinHistory', () => {
  const event = (time: number, text: string): Uint8Array => encode.event(time, { code: 'x', level: 'info', text });

  it('has each event once, and every one', () => {
    const history = [event(1, 'a'), event(2, 'b'), motion(3), event(3, 'c')];
    const live = [motion(0.5), event(3, 'c'), event(3, 'd'), event(4, 'e')];
    const timeline = new Timeline();
    for (const bytes of joinHistory(history, live)) timeline.append(bytes);
    expect(timeline.head.events.map(({ text }) => text)).toEqual(['a', 'b', 'c', 'd', 'e']);
  });

  it('is what came live where there is no history', () => {
    expect(joinHistory([], [motion(1)])).toHaveLength(1);
  });
});

describe('splitHistory', () => {
  it('reads messages behind their lengths, and leaves out one that is cut off', () => {
    const first = motion(1);
    const second = state(2, 'go');
    const bytes = new Uint8Array(8 + first.length + second.length);
    const view = new DataView(bytes.buffer);
    view.setUint32(0, first.length, true);
    bytes.set(first, 4);
    view.setUint32(4 + first.length, second.length, true);
    bytes.set(second, 8 + first.length);
    expect(splitHistory(bytes.buffer).map((message) => decode(message)?.kind)).toEqual(['motion', 'state']);
    expect(splitHistory(bytes.buffer.slice(0, -1))).toHaveLength(1);
    expect(splitHistory(new ArrayBuffer(3))).toHaveLength(0);
  });
});

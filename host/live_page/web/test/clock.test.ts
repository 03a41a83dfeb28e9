// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { decodeText } from '../src/protocol/commands';
import { ServerClock } from '../src/protocol/server_clock';

describe('ServerClock', () => {
  it('trusts the fastest ping', () => {
    const clock = new ServerClock();
    expect(clock.ageMs(0, 0)).toBeNull();
    clock.addPong(1000, 1100, 5090);
    clock.addPong(2000, 2004, 6002);
    expect(clock.roundTripMs).toBe(4);
    expect(clock.ageMs(6500, 2510)).toBeCloseTo(10);
  });

  it('knows the newest that it has seen', () => {
    const clock = new ServerClock();
    clock.see(50);
    clock.see(40);
    expect(clock.seenMs).toBe(50);
    clock.reset();
    expect(clock.seenMs).toBe(0);
  });
});

describe('decodeText', () => {
  it('reads the number by which the server names this client', () => {
    expect(decodeText('{"client": 3}')).toEqual({ client: 3 });
  });

  it('reads an answer, and ignores anything else', () => {
    expect(decodeText('{"ack": 3, "ok": false, "code": "stale"}')).toEqual({ ack: 3, ok: false, code: 'stale' });
    for (const text of ['', '3', 'null', '{"ok": true}', '{"ack": "3", "ok": true}', '{"ack": 3']) {
      expect(decodeText(text)).toBeNull();
    }
  });
});

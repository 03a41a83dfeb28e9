// SPDX-License-Identifier: MIT
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { DriveSampler, type Steering } from '../src/drive/drive_sampler';
import { steeringOfStick } from '../src/drive/joystick_steering';
import { isDriveKey, steeringOfKeys } from '../src/drive/keyboard';

class FakeLine {
  sent: Steering[] = [];
  released = 0;
  ready = true;
  underWay = 0;
  mostUnderWay = 0;
  private answers: (() => void)[] = [];

  isReady = (): boolean => this.ready;
  drive = (steering: Steering): Promise<unknown> => {
    this.sent.push(steering);
    if (steering.forward !== 0 || steering.turn !== 0) {
      this.underWay += 1;
      this.mostUnderWay = Math.max(this.mostUnderWay, this.underWay);
    }
    return new Promise<void>((resolve) => this.answers.push(resolve));
  };
  release = (): void => {
    this.released += 1;
  };
  async answerAll(): Promise<void> {
    this.underWay = 0;
    for (const answer of this.answers.splice(0)) answer();
    await Promise.resolve();
    await Promise.resolve();
  }
}

const ahead: Steering = { forward: 1, turn: 0 };
const left: Steering = { forward: 0, turn: 1 };

describe('DriveSampler', () => {
  let line: FakeLine;
  let sampler: DriveSampler;
  beforeEach(() => {
    vi.useFakeTimers();
    line = new FakeLine();
    sampler = new DriveSampler(line, () => Date.now());
  });
  afterEach(() => vi.useRealTimers());

  it('steers at once and every 100 ms while something is held', async () => {
    sampler.hold('keyboard', ahead);
    expect(line.sent).toEqual([ahead]);
    for (let sample = 0; sample < 5; ++sample) {
      await line.answerAll();
      await vi.advanceTimersByTimeAsync(100);
    }
    expect(line.sent).toHaveLength(6);
  });

  it('has one command under way at most, then sends the newest', async () => {
    sampler.hold('joystick', ahead);
    await vi.advanceTimersByTimeAsync(100);
    sampler.hold('joystick', left);
    await vi.advanceTimersByTimeAsync(100);
    expect(line.sent).toEqual([ahead]);
    await line.answerAll();
    expect(line.sent).toEqual([ahead, left]);
    expect(line.mostUnderWay).toBe(1);
  });

  it('gives up on an answer after 250 ms', async () => {
    sampler.hold('keyboard', ahead);
    await vi.advanceTimersByTimeAsync(300);
    expect(line.sent).toHaveLength(2);
  });

  it('sends nothing while bytes wait in the browser', async () => {
    line.ready = false;
    sampler.hold('keyboard', ahead);
    await vi.advanceTimersByTimeAsync(500);
    expect(line.sent).toEqual([]);
    line.ready = true;
    await vi.advanceTimersByTimeAsync(100);
    expect(line.sent).toEqual([ahead]);
  });

  it('sends one zero when let go, and nothing after it', async () => {
    sampler.hold('keyboard', ahead);
    sampler.hold('keyboard', null);
    expect(line.sent.at(-1)).toEqual({ forward: 0, turn: 0 });
    await line.answerAll();
    await vi.advanceTimersByTimeAsync(1000);
    expect(line.sent).toHaveLength(2);
    expect(line.released).toBe(0);
    expect(sampler.isDriving).toBe(false);
  });

  it('goes on with what is still held', async () => {
    sampler.hold('keyboard', ahead);
    sampler.hold('joystick', left);
    expect(sampler.steering).toEqual(left);
    sampler.hold('joystick', null);
    expect(sampler.steering).toEqual(ahead);
    expect(sampler.isDriving).toBe(true);
  });

  it('stops at once in a hidden tab', async () => {
    sampler.hold('keyboard', ahead);
    await line.answerAll();
    sampler.abandon();
    expect(line.released).toBe(1);
    await vi.advanceTimersByTimeAsync(1000);
    expect(line.sent).toHaveLength(1);
  });

  it('releases nothing where nothing was held', () => {
    sampler.abandon();
    expect(line.released).toBe(0);
  });

  it('steers again only after letting go, and says so by a zero first', async () => {
    sampler.hold('joystick', ahead);
    sampler.drop();
    sampler.hold('joystick', left);
    await vi.advanceTimersByTimeAsync(500);
    expect(line.sent).toEqual([ahead]);
    sampler.hold('joystick', null);
    expect(line.sent).toEqual([ahead]);
    sampler.hold('joystick', left);
    expect(line.sent).toEqual([ahead, { forward: 0, turn: 0 }, left]);
  });

  it('sends nothing more once STOP was pressed', async () => {
    sampler.hold('keyboard', ahead);
    await vi.advanceTimersByTimeAsync(100);
    sampler.drop();
    await line.answerAll();
    await vi.advanceTimersByTimeAsync(1000);
    expect(line.sent).toHaveLength(1);
  });
});

describe('steeringOfStick', () => {
  it('is zero in the middle and full at the edge', () => {
    expect(steeringOfStick(0.05, -0.05)).toEqual({ forward: 0, turn: 0 });
    expect(steeringOfStick(0, -1).forward).toBeCloseTo(1);
    expect(steeringOfStick(-1, 0).turn).toBeCloseTo(1);
  });

  it('never exceeds the robot’s speeds', () => {
    const { forward, turn } = steeringOfStick(3, 4);
    expect(Math.hypot(forward, turn)).toBeCloseTo(1);
  });
});

describe('steeringOfKeys', () => {
  it('adds keys up', () => {
    expect(steeringOfKeys(new Set())).toBeNull();
    expect(steeringOfKeys(new Set(['KeyW', 'ArrowUp']))).toEqual({ forward: 1, turn: 0 });
    expect(steeringOfKeys(new Set(['KeyW', 'KeyS']))).toEqual({ forward: 0, turn: 0 });
    expect(steeringOfKeys(new Set(['KeyW', 'KeyA']))?.turn).toBeGreaterThan(0);
    expect(isDriveKey('KeyQ')).toBe(false);
  });
});

// SPDX-License-Identifier: MIT
import { describe, expect, it, vi } from 'vitest';
import { overlap } from '../src/map/draw_shapes';

const box = (left: number, top: number) => ({ left, top, right: left + 10, bottom: top + 10 });

describe('overlap', () => {
  it('is where boxes share more than an edge', () => {
    expect(overlap(box(0, 0), box(9, 9))).toBe(true);
    expect(overlap(box(0, 0), box(10, 0))).toBe(false);
    expect(overlap(box(0, 0), box(5, 20))).toBe(false);
  });
});

describe('plusMinus', () => {
  it('does not call a small spread nothing', async () => {
    vi.stubGlobal('localStorage', { getItem: () => null });
    vi.stubGlobal('navigator', { languages: ['en'] });
    const { plusMinus } = await import('../src/format');
    vi.unstubAllGlobals();
    expect(plusMinus(0)).toBe('< 1\u00a0cm');
    expect(plusMinus(0.034)).toBe('± 3.4\u00a0cm');
  });
});

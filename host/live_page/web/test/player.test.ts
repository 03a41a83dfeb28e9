// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { Player } from '../src/run/player';

describe('Player', () => {
  it('plays at its speed up to the end', () => {
    const player = new Player();
    player.toTime(10);
    player.speed.value = 20;
    player.togglePlaying(0, 60);
    player.advance(0.5, 60);
    expect(player.time.value).toBeCloseTo(20);
    player.advance(10, 60);
    expect(player.time.value).toBe(60);
    expect(player.playing.value).toBe(false);
  });

  it('starts over where it has come to the end', () => {
    const player = new Player();
    player.toTime(60);
    player.togglePlaying(5, 60);
    expect(player.time.value).toBe(5);
    expect(player.playing.value).toBe(true);
  });

  it('stands still while it pauses, and follows a live run again', () => {
    const player = new Player();
    player.toTime(3);
    player.advance(1, 60);
    expect(player.time.value).toBe(3);
    expect(player.live.value).toBe(false);
    player.toLive();
    expect(player.live.value).toBe(true);
  });
});

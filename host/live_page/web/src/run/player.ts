// SPDX-License-Identifier: MIT
import { signal } from '@preact/signals';

export const playbackSpeeds = [1, 2, 5, 10, 20, 50] as const;

/** Which instant of the run is shown. */
export class Player {
  /** True: the newest of a live run, whatever the time. */
  readonly live = signal(true);
  readonly time = signal(0);
  readonly playing = signal(false);
  readonly speed = signal<number>(1);

  toLive(): void {
    this.live.value = true;
    this.playing.value = false;
  }

  toTime(time: number): void {
    this.live.value = false;
    this.time.value = time;
  }

  togglePlaying(start: number, end: number): void {
    if (!this.playing.value && this.time.value >= end) this.time.value = start;
    this.live.value = false;
    this.playing.value = !this.playing.value;
  }

  pause(): void {
    this.playing.value = false;
  }

  /** Lets so many seconds of a clock on the wall pass. */
  advance(seconds: number, end: number): void {
    if (!this.playing.value) return;
    this.time.value = Math.min(end, this.time.value + seconds * this.speed.value);
    if (this.time.value >= end) this.playing.value = false;
  }
}

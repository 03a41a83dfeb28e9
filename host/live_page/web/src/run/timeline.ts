// SPDX-License-Identifier: MIT
import { decode, Kind, kindOf, timeOf } from '../protocol/decode';
import type { Message } from '../protocol/messages';
import { apply, cloneView, emptyView, type View } from './view';

/** An encoded message. */
export type Encoded = Uint8Array;

const keyframeEvery = 400;
const maxBytes = 192 * 2 ** 20;
const motionStepS = 0.1;
const particlesStepS = 1;

/** Messages of a history, in their order; a last one that is cut off is left out. */
export function splitHistory(history: ArrayBuffer): Encoded[] {
  const view = new DataView(history);
  const messages: Encoded[] = [];
  for (let offset = 0; offset + 4 <= history.byteLength; ) {
    const length = view.getUint32(offset, true);
    offset += 4;
    if (offset + length > history.byteLength) break;
    messages.push(new Uint8Array(history, offset, length));
    offset += length;
  }
  return messages;
}

/** A history, and of what came live what is not in it. */
export function joinHistory(history: readonly Encoded[], live: readonly Encoded[]): Encoded[] {
  const end = history.reduce((newest, bytes) => Math.max(newest, timeOf(bytes)), -Infinity);
  const atEnd = history.filter((bytes) => timeOf(bytes) === end);
  const later = live.filter((bytes) => {
    const time = timeOf(bytes);
    return time > end || (time === end && !atEnd.some((known) => sameBytes(known, bytes)));
  });
  return [...history, ...later];
}

function sameBytes(a: Encoded, b: Encoded): boolean {
  return a.length === b.length && a.every((byte, index) => byte === b[index]);
}

/** A view at an instant, that moves along a timeline. */
export interface Cursor {
  view: View;
  /** Of the first message that is not in the view. */
  next: number;
}

/** All messages of a run so far, and the view at any instant of them. */
export class Timeline {
  /** The view after the last message. */
  readonly head: View = emptyView();
  private readonly messages: Encoded[] = [];
  private readonly times: number[] = [];
  private readonly keyframes: Cursor[] = [{ view: emptyView(), next: 0 }];
  private bytes = 0;
  private nextMotionS = -Infinity;
  private nextParticlesS = -Infinity;

  get start(): number {
    return this.times[0] ?? 0;
  }
  get end(): number {
    return this.head.time;
  }
  get length(): number {
    return this.messages.length;
  }

  /** Null where the message says nothing. */
  append(bytes: Encoded): Message | null {
    const message = decode(bytes);
    if (!message) return null;
    apply(this.head, message);
    if (this.isKept(kindOf(bytes), message.time)) {
      this.messages.push(bytes);
      this.times.push(this.head.time);
      this.bytes += bytes.length;
      if (this.messages.length % keyframeEvery === 0) {
        this.keyframes.push({ view: cloneView(this.head), next: this.messages.length });
      }
    }
    return message;
  }

  /** The view at the instant, going on from the cursor where that is shorter. */
  seek(time: number, from?: Cursor): Cursor {
    const end = this.indexAfter(time);
    let cursor = from;
    const keyframe = this.keyframeBefore(end);
    if (!cursor || cursor.next > end || cursor.next < keyframe.next) {
      cursor = { view: cloneView(keyframe.view), next: keyframe.next };
    }
    for (; cursor.next < end; ++cursor.next) {
      const bytes = this.messages[cursor.next];
      const message = bytes && decode(bytes);
      if (message) apply(cursor.view, message);
    }
    return cursor;
  }

  private isKept(kind: number, time: number): boolean {
    if (kind !== Kind.motion && kind !== Kind.particles) return true;
    if (this.bytes > maxBytes) return false;
    if (kind === Kind.motion) {
      if (time < this.nextMotionS) return false;
      this.nextMotionS = time + motionStepS * 0.95;
    } else {
      if (time < this.nextParticlesS) return false;
      this.nextParticlesS = time + particlesStepS * 0.95;
    }
    return true;
  }

  private indexAfter(time: number): number {
    let low = 0;
    let high = this.times.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((this.times[middle] ?? Infinity) <= time) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  private keyframeBefore(index: number): Cursor {
    const count = Math.floor(index / keyframeEvery);
    return this.keyframes[Math.min(count, this.keyframes.length - 1)]!;
  }
}

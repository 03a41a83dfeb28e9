// SPDX-License-Identifier: MIT
import {
  type Hello,
  type Message,
  type Motion,
  type PingOutcome,
  type Pose,
  type Room,
  type RunEvent,
  type RunState,
  type Team,
  tileCells,
} from './messages';

export const headerBytes = 16;
const motionBytes = 76;
const littleEndian = true;

export const enum Kind {
  hello = 1,
  tile,
  motion,
  particles,
  trail,
  room,
  state,
  event,
  newMap,
  team,
}

export function kindOf(bytes: Uint8Array): number {
  return bytes[0] ?? 0;
}

/** Seconds since the run's start, or NaN where the header is incomplete. */
export function timeOf(bytes: Uint8Array): number {
  return bytes.length < headerBytes ? NaN : viewOf(bytes).getFloat64(8, littleEndian);
}

/** Null for a message that is unknown, truncated or malformed. */
export function decode(bytes: Uint8Array): Message | null {
  const time = timeOf(bytes);
  if (!Number.isFinite(time)) return null;
  const body = bytes.subarray(headerBytes);
  switch (kindOf(bytes)) {
    case Kind.hello: {
      const hello = decodeJson<Hello>(body);
      return hello && { kind: 'hello', time, hello };
    }
    case Kind.tile: {
      if (body.length < 8 + tileCells * tileCells) return null;
      const view = viewOf(body);
      const cells = body.subarray(8, 8 + tileCells * tileCells);
      return {
        kind: 'tile',
        time,
        tile: { x: view.getInt32(0, littleEndian), y: view.getInt32(4, littleEndian), cells },
      };
    }
    case Kind.motion:
      return body.length < motionBytes ? null : { kind: 'motion', time, motion: decodeMotion(viewOf(body)) };
    case Kind.particles: {
      const particles = decodeFloats(body, 4);
      return particles && { kind: 'particles', time, particles };
    }
    case Kind.trail: {
      const trail = decodeFloats(body, 2);
      return trail && { kind: 'trail', time, trail };
    }
    case Kind.room: {
      const room = decodeJson<Room>(body);
      return room && { kind: 'room', time, room };
    }
    case Kind.state: {
      const state = decodeJson<RunState>(body);
      return state && { kind: 'state', time, state };
    }
    case Kind.event: {
      const event = decodeJson<RunEvent>(body);
      return event && { kind: 'event', time, event };
    }
    case Kind.newMap:
      return { kind: 'newMap', time };
    case Kind.team: {
      const team = decodeJson<Team>(body);
      return team && { kind: 'team', time, team };
    }
    default:
      return null;
  }
}

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

function decodeJson<T extends object>(body: Uint8Array): T | null {
  try {
    const value: unknown = JSON.parse(new TextDecoder().decode(body));
    return typeof value === 'object' && value !== null && !Array.isArray(value) ? (value as T) : null;
  } catch {
    return null;
  }
}

function decodeFloats(body: Uint8Array, perItem: number): Float32Array | null {
  if (body.length < 8) return null;
  const count = viewOf(body).getUint32(0, littleEndian) * perItem;
  if (body.length - 8 < count * 4) return null;
  const start = body.byteOffset + 8;
  return new Float32Array(body.buffer.slice(start, start + count * 4));
}

function decodeMotion(view: DataView): Motion {
  const float = (offset: number): number => view.getFloat32(offset, littleEndian);
  const pose = (offset: number): Pose => ({ x: float(offset), y: float(offset + 4), heading: float(offset + 8) });
  const orNull = (value: number): number | null => (Number.isFinite(value) ? value : null);
  const covariance = { xx: float(20), xy: float(24), yy: float(28) };
  const truth = pose(48);
  return {
    clockMs: view.getFloat64(0, littleEndian),
    pose: pose(8),
    covariance: Number.isFinite(covariance.xx + covariance.xy + covariance.yy) ? covariance : null,
    headingStddev: orNull(float(32)),
    odometry: pose(36),
    truth: Number.isFinite(truth.x + truth.y + truth.heading) ? truth : null,
    ping: {
      bearing: float(60),
      range: orNull(float(64)),
      number: view.getUint32(68, littleEndian),
      outcome: view.getUint32(72, littleEndian) as PingOutcome,
    },
  };
}

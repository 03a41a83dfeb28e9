// SPDX-License-Identifier: MIT
// Messages of docs/live_protocol.md, as a server sends them.

const headerBytes = 16;

function message(kind, time, bodyBytes) {
  const bytes = Buffer.alloc(headerBytes + bodyBytes);
  bytes[0] = kind;
  bytes.writeDoubleLE(time, 8);
  return bytes;
}

function json(kind, time, value) {
  const body = Buffer.from(JSON.stringify(value));
  return Buffer.concat([message(kind, time, 0), body]);
}

export const hello = (time, value) => json(1, time, value);
export const room = (time, value) => json(6, time, value);
export const state = (time, value) => json(7, time, value);
export const event = (time, value) => json(8, time, value);
export const newMap = (time) => message(9, time, 0);
export const team = (time, value) => json(10, time, value);

export function tile(time, x, y, cells) {
  const bytes = message(2, time, 8 + 64 * 64);
  bytes.writeInt32LE(x, 16);
  bytes.writeInt32LE(y, 20);
  bytes.set(cells, 24);
  return bytes;
}

export function motion(time, values) {
  const bytes = message(3, time, 76);
  const floats = (offset, numbers) => numbers.forEach((value, index) => bytes.writeFloatLE(value, 16 + offset + 4 * index));
  bytes.writeDoubleLE(values.clockMs, 16);
  floats(8, values.pose);
  floats(20, values.covariance);
  floats(32, [values.headingStddev]);
  floats(36, values.odometry);
  floats(48, values.truth);
  floats(60, [values.ping.bearing, values.ping.range]);
  bytes.writeUInt32LE(values.ping.number, 16 + 68);
  bytes.writeUInt32LE(values.ping.outcome, 16 + 72);
  return bytes;
}

function floats(kind, time, perItem, numbers) {
  const bytes = message(kind, time, 8 + 4 * numbers.length);
  bytes.writeUInt32LE(numbers.length / perItem, 16);
  numbers.forEach((value, index) => bytes.writeFloatLE(value, 24 + 4 * index));
  return bytes;
}

export const particles = (time, numbers) => floats(4, time, 4, numbers);
export const trail = (time, numbers) => floats(5, time, 2, numbers);

// SPDX-License-Identifier: MIT
import type { MotionValues } from '../test/messages';

type Encoded = Uint8Array;
export function hello(time: number, value: object): Encoded;
export function room(time: number, value: object): Encoded;
export function state(time: number, value: object): Encoded;
export function event(time: number, value: object): Encoded;
export function newMap(time: number): Encoded;
export function team(time: number, value: object): Encoded;
export function tile(time: number, x: number, y: number, cells: Uint8Array): Encoded;
export function motion(time: number, values: MotionValues): Encoded;
export function particles(time: number, numbers: number[]): Encoded;
export function trail(time: number, numbers: number[]): Encoded;

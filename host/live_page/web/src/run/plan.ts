// SPDX-License-Identifier: MIT
import type { RunState } from '../protocol/messages';

const planless: (string | null | undefined)[] = ['drive', 'stopped', 'ended', 'recording'];

/** What it does and why; null while that is up to a person, nothing moves, or nobody noted it. */
export function planOf(state: RunState | null): RunState['why'] {
  return state && !planless.includes(state.mode) ? state.why : null;
}

// SPDX-License-Identifier: MIT
import type { Steering } from './drive_sampler';

const turnShare = 0.6;
const directions: Record<string, Steering> = {
  KeyW: { forward: 1, turn: 0 },
  ArrowUp: { forward: 1, turn: 0 },
  KeyS: { forward: -1, turn: 0 },
  ArrowDown: { forward: -1, turn: 0 },
  KeyA: { forward: 0, turn: turnShare },
  ArrowLeft: { forward: 0, turn: turnShare },
  KeyD: { forward: 0, turn: -turnShare },
  ArrowRight: { forward: 0, turn: -turnShare },
};

export function isDriveKey(code: string): boolean {
  return code in directions;
}

/** Of the keys that are held; null while there is none. */
export function steeringOfKeys(held: ReadonlySet<string>): Steering | null {
  if (held.size === 0) return null;
  const clamp = (share: number): number => Math.max(-1, Math.min(1, share));
  let forward = 0;
  let turn = 0;
  for (const code of held) {
    forward += directions[code]?.forward ?? 0;
    turn += directions[code]?.turn ?? 0;
  }
  return { forward: clamp(forward), turn: clamp(turn) };
}

/** Whether keys belong to that element: text is typed there, or it has arrows of its own. */
export function ownsKeys(target: EventTarget | null, code: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  const typesText =
    target.isContentEditable ||
    target instanceof HTMLTextAreaElement ||
    (target instanceof HTMLInputElement && target.type !== 'range');
  if (typesText) return true;
  const hasArrows = target instanceof HTMLSelectElement || target instanceof HTMLInputElement;
  return (hasArrows || target.role === 'tab') && code.startsWith('Arrow');
}

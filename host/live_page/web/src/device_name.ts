// SPDX-License-Identifier: MIT
import { signal } from '@preact/signals';
import { text } from './language';

const storageKey = 'echomap.name';
const maxLength = 24;

function deviceKind(): string {
  const smallerEdge = Math.min(screen.width, screen.height);
  if (!matchMedia('(pointer: coarse)').matches) return text('device.laptop');
  return text(smallerEdge < 600 ? 'device.phone' : 'device.tablet');
}

/** What others see of this page where it drives. */
export const deviceName = signal(localStorage.getItem(storageKey) ?? deviceKind());

export function setDeviceName(name: string): void {
  const trimmed = name.trim().slice(0, maxLength);
  deviceName.value = trimmed || deviceKind();
  localStorage.setItem(storageKey, trimmed);
  if (!trimmed) localStorage.removeItem(storageKey);
}

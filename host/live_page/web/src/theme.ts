// SPDX-License-Identifier: MIT
import { signal } from '@preact/signals';
import type { Theme } from './map/palette';

const storageKey = 'echomap.theme';
const prefersDark = matchMedia('(prefers-color-scheme: dark)');

export const theme = signal<Theme>('light');

function resolve(): void {
  const chosen = localStorage.getItem(storageKey);
  theme.value = chosen === 'light' || chosen === 'dark' ? chosen : prefersDark.matches ? 'dark' : 'light';
  document.documentElement.dataset.theme = theme.value;
}

export function startTheme(): void {
  resolve();
  prefersDark.addEventListener('change', resolve);
}

export function toggleTheme(): void {
  localStorage.setItem(storageKey, theme.value === 'dark' ? 'light' : 'dark');
  resolve();
}

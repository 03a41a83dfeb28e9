// SPDX-License-Identifier: MIT
import { language } from './language';

const missing = '–';

export function number(value: number | null | undefined, digits = 0): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return missing;
  return value.toLocaleString(language.value, { minimumFractionDigits: digits, maximumFractionDigits: digits });
}

function withUnit(value: number | null | undefined, digits: number, unit: string): string {
  const shown = number(value, digits);
  return shown === missing ? missing : `${shown}\u00a0${unit}`;
}

export function metres(value: number | null | undefined): string {
  return withUnit(value, 2, 'm');
}
/** Centimetres below a metre. */
export function shortDistance(value: number | null | undefined): string {
  if (value === null || value === undefined || value >= 1) return metres(value);
  return withUnit(value * 100, value < 0.0995 ? 1 : 0, 'cm');
}
/** Of a spread: what is nearly nothing is not called nothing. */
export function plusMinus(value: number): string {
  return value < 0.01 ? '< 1\u00a0cm' : `± ${shortDistance(value)}`;
}
export function area(value: number | null | undefined): string {
  return withUnit(value, 1, 'm²');
}
export function percent(share: number | null | undefined, digits = 0): string {
  return withUnit(share === null || share === undefined ? null : share * 100, digits, '%');
}
export function degrees(radians: number | null | undefined): string {
  return withUnit(radians === null || radians === undefined ? null : (radians * 180) / Math.PI, 0, '°');
}
export function milliseconds(value: number | null | undefined): string {
  return withUnit(value, value !== null && value !== undefined && value < 10 ? 1 : 0, 'ms');
}
export function volts(value: number | null | undefined): string {
  return withUnit(value, 1, 'V');
}
/** Minutes and seconds, as 3:07. */
export function duration(seconds: number | null | undefined): string {
  if (seconds === null || seconds === undefined || !Number.isFinite(seconds)) return missing;
  const whole = Math.max(0, Math.floor(seconds));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`;
}
export function bytes(count: number): string {
  if (count < 1000) return withUnit(count, 0, 'B');
  return count < 1e6 ? withUnit(count / 1e3, 1, 'kB') : withUnit(count / 1e6, 1, 'MB');
}

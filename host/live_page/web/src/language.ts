// SPDX-License-Identifier: MIT
import { signal } from '@preact/signals';
import { serverTexts } from './server_texts';
import { type Language, languages, type TextKey, texts } from './texts';

const storageKey = 'echomap.language';

export const language = signal<Language>(firstLanguage());

function firstLanguage(): Language {
  const wanted = [localStorage.getItem(storageKey), ...navigator.languages].map((tag) => tag?.slice(0, 2));
  return languages.find((known) => known === wanted.find((tag) => languages.some((any) => any === tag))) ?? 'en';
}

export function setLanguage(chosen: Language): void {
  language.value = chosen;
  localStorage.setItem(storageKey, chosen);
}

/** In the page's language, with {names} filled in. */
export function text(key: TextKey, values: Record<string, string> = {}): string {
  return texts[key][language.value].replace(/\{(\w+)\}/g, (placeholder, name: string) => values[name] ?? placeholder);
}

/** Of a code of the protocol; what the server says where the page has no words of its own. */
export function codeText(group: string, code: string | null | undefined, otherwise: string | null | undefined): string {
  const key = `${group}.${code}`;
  return key in texts ? text(key as TextKey) : (serverTexts[language.value]?.[key] ?? otherwise ?? '');
}

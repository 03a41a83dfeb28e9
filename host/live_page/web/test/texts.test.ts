// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { languages, texts } from '../src/texts';

const codes = {
  mode: ['connecting', 'explore', 'drive', 'go', 'stopped', 'lost-link', 'ended', 'recording'],
  why: ['frontier', 'known-walls', 'opening', 'sweep', 'operator', 'strategy'],
  stopped: ['stop', 'driver-gone', 'driver-silent', 'bumped', 'hazard', 'stalled', 'lifted', 'link-lost', 'no-way'],
  refused: ['unknown', 'malformed', 'not-possible', 'stale', 'not-driver', 'busy'],
  level: ['info', 'warning', 'error'],
};

describe('texts', () => {
  it('are complete in each language, with the same placeholders', () => {
    for (const [key, translations] of Object.entries(texts)) {
      const placeholders = languages.map((language) => translations[language].match(/\{\w+\}/g) ?? []);
      for (const language of languages) expect(translations[language].trim(), `${key} ${language}`).not.toBe('');
      expect(placeholders[1], key).toEqual(placeholders[0]);
    }
  });

  it('know every code of the protocol', () => {
    for (const [group, names] of Object.entries(codes)) {
      for (const name of names) expect(texts).toHaveProperty([`${group}.${name}`]);
    }
    for (const name of codes.stopped) expect(texts).toHaveProperty([`stopped.${name}.remedy`]);
  });
});

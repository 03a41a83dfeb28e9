// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import kidnap from '../../../apps/demo_kidnap.cpp?raw';
import liveRun from '../../../apps/live_run.cpp?raw';
import clientCommand from '../../client_command.cpp?raw';
import eventWatch from '../../event_watch.cpp?raw';
import runState from '../../run_state.cpp?raw';
import { codes } from '../src/protocol/codes';
import { serverTexts } from '../src/server_texts';
import { languages, texts } from '../src/texts';

/** In English the server's own sentence is shown. */
const saidByServer = ['stopped', 'event'];
const found = (text: string, pattern: RegExp): string[] => [...text.matchAll(pattern)].map((match) => match[1]!);

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
      for (const name of names) {
        const key = `${group}.${name}`;
        if (saidByServer.includes(group)) expect(serverTexts.de).toHaveProperty([key]);
        else expect(texts).toHaveProperty([key]);
      }
    }
    for (const name of codes.stopped) expect(texts).toHaveProperty([`stopped.${name}.remedy`]);
  });

  it('know the cause and the remedy where the server tells them', () => {
    const told = eventWatch.matchAll(/\{\{?"([a-z-]+)",\s*Level::k\w+,((?:\s*"[^"]*",?)+)\s*\}/g);
    for (const [, code, sentences] of told) {
      const [, cause, remedy] = sentences!.replaceAll(/"\s*"/g, '').match(/"[^"]*"/g)!;
      if (cause && cause !== '""') expect(serverTexts.de).toHaveProperty([`event.${code}.cause`]);
      if (remedy && remedy !== '""') expect(serverTexts.de).toHaveProperty([`event.${code}.remedy`]);
    }
  });
});

describe('codes', () => {
  it('has those of the events', () => {
    const watched = found(eventWatch, /push_back\(\s*\{"([a-z-]+)"/g);
    const told = [liveRun, kidnap].flatMap((source) =>
      found(source, /tell\(\{\s*"([a-z-]+)"/g),
    );
    expect(new Set([...watched, ...told])).toEqual(new Set(codes.event));
  });

  it('has those of the state and of refusals', () => {
    const stopped = found(runState, /return \{"([a-z-]+)", "/g);
    expect(new Set(stopped)).toEqual(new Set(codes.stopped));
    const [, modes, reasons] = runState.split('const char* ');
    expect(new Set(found(modes!, /return "([a-z-]+)"/g))).toEqual(new Set(codes.mode));
    expect(new Set(found(reasons!, /return "([a-z-]+)"/g))).toEqual(new Set(codes.why));
    const refused = clientCommand.split('name_of(RefusalCode')[1]!;
    expect(new Set(found(refused, /return "([a-z-]+)"/g))).toEqual(new Set(codes.refused));
  });
});

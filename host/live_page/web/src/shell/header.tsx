// SPDX-License-Identifier: MIT
import type { JSX } from 'preact';
import { language, setLanguage, text } from '../language';
import type { Session } from '../session';
import { toggleTheme } from '../theme';
import { Icon } from './icons';
import { LinkPill } from './link_pill';
import { StopButton } from './stop_button';

export function Header({ session }: { session: Session }): JSX.Element {
  const runs = session.runs.value;
  const name = session.shown.value.view.hello?.name ?? text('app.subtitle');
  return (
    <header class="header">
      <div class="brand">
        <img src="favicon.svg" alt="" width="32" height="32" />
        <div class="brand-words">
          <h1>echomap</h1>
          {runs.length > 1 ? (
            <select
              aria-label={text('app.run')}
              value={session.shownRun.value ?? ''}
              onChange={(event) => void session.showRun(event.currentTarget.value)}
            >
              {runs.map((run) => (
                <option key={run.id} value={run.id}>
                  {run.name} · {text(run.live ? 'app.live' : 'app.recorded')}
                </option>
              ))}
            </select>
          ) : (
            <p class="run-name">{name}</p>
          )}
        </div>
      </div>
      <div class="header-tools">
        <LinkPill session={session} />
        <button
          type="button"
          class="quiet"
          title={text('app.language')}
          lang={language.value === 'en' ? 'de' : 'en'}
          onClick={() => setLanguage(language.value === 'en' ? 'de' : 'en')}
        >
          <span class="visually-hidden">{text('app.language')}</span>
          <span aria-hidden="true">{text('app.languageShort')}</span>
        </button>
        <button type="button" class="quiet square" title={text('app.theme')} aria-label={text('app.theme')} onClick={toggleTheme}>
          <Icon name="theme" />
        </button>
      </div>
      <StopButton session={session} />
    </header>
  );
}

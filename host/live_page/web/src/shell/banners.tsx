// SPDX-License-Identifier: MIT
import { useSignal } from '@preact/signals';
import type { ComponentChildren, JSX } from 'preact';
import { duration } from '../format';
import { codeText, text } from '../language';
import type { Session } from '../session';
import { type IconName, Icon } from './icons';

function Banner(props: { kind: string; icon: IconName; children: ComponentChildren }): JSX.Element {
  return (
    <div class={`banner banner-${props.kind}`}>
      <Icon name={props.icon} />
      <div>{props.children}</div>
    </div>
  );
}

const trouble = { kind: 'warning', icon: 'weak' } as const;
const arrival = { kind: 'good', icon: 'good' } as const;

/** What somebody has to know now, above the map. */
export function Banners({ session }: { session: Session }): JSX.Element {
  const { state } = session.shown.value.view;
  const isNow = session.player.live.value && session.isLiveRun.value;
  const stopped = state?.stopped;
  const isLost = session.linkStatus.value === 'lost';
  const hasEnded = state?.mode === 'ended';
  return (
    <div class="banners">
      {isLost && hasEnded && (
        <Banner kind="info" icon="info">
          {text('connection.ended')}
        </Banner>
      )}
      {isLost && !hasEnded && (
        <Banner kind="error" icon="down">
          <strong>{text('connection.lost')}</strong> {text('connection.lostMeaning')}
        </Banner>
      )}
      {session.stopStatus.value === 'unconfirmed' && (
        <Banner kind="error" icon="weak">
          <strong>{text('stop.unconfirmedLong')}</strong>
        </Banner>
      )}
      {session.notice.value && (
        <Banner kind={session.notice.value.isError ? 'warning' : 'info'} icon="info">
          {session.notice.value.words}
        </Banner>
      )}
      {session.isLiveRun.value && !isNow && (
        <Banner kind="info" icon="info">
          {text('timeline.past', { time: duration(session.player.time.value) })}{' '}
          <button type="button" class="small" onClick={() => session.toLive()}>
            {text('timeline.toLive')}
          </button>
        </Banner>
      )}
      {stopped && (
        <Banner {...(stopped.code === 'arrived' ? arrival : trouble)}>
          <strong class="sentence">{codeText('stopped', stopped.code, stopped.text)}.</strong>{' '}
          {codeText('stopped', `${stopped.code}.remedy`, '')}
        </Banner>
      )}
      {state?.mode === 'lost-link' && (
        <Banner kind="error" icon="down">
          <strong>{text('link.lostLong')}.</strong> {text('link.lostLong.remedy')}
        </Banner>
      )}
      <ResultBanner session={session} />
    </div>
  );
}

function ResultBanner({ session }: { session: Session }): JSX.Element | null {
  const closed = useSignal<string | null>(null);
  const copied = useSignal(false);
  const result = session.shown.value.view.state?.result;
  if (!result || closed.value === session.shownRun.value) return null;
  const { next } = result;
  return (
    <Banner kind={result.finished ? 'good' : 'warning'} icon={result.finished ? 'good' : 'weak'}>
      <strong>{text(result.finished ? 'result.finished' : 'result.unfinished')}.</strong> {result.why}
      {next && (
        <p class="next">
          {text('result.next')}: <code>{next}</code>
        </p>
      )}
      <div class="banner-buttons">
        {next && (
          <button
            type="button"
            class="small next"
            onClick={() => {
              void navigator.clipboard?.writeText(next).then(() => (copied.value = true));
            }}
          >
            {text(copied.value ? 'result.copied' : 'result.copy')}
          </button>
        )}
        <button type="button" class="small" onClick={() => (closed.value = session.shownRun.value)}>
          {text('result.close')}
        </button>
      </div>
    </Banner>
  );
}

/** The same for those who do not see it. */
export function LiveRegion({ session }: { session: Session }): JSX.Element {
  const { state } = session.shown.value.view;
  const status = session.stopStatus.value;
  return (
    <>
      <div class="visually-hidden" role="status">
        {state?.mode ? codeText('mode', state.mode, state.mode) : ''} {session.notice.value?.words}
      </div>
      <div class="visually-hidden" role="alert">
        {status === 'confirmed' ? text('stop.confirmedLong') : ''}
        {status === 'unconfirmed' ? text('stop.unconfirmedLong') : ''}
        {session.linkStatus.value === 'lost' ? text('connection.lost') : ''}
      </div>
    </>
  );
}

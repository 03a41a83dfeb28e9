// SPDX-License-Identifier: MIT
import type { JSX } from 'preact';
import { area, degrees, duration, metres, milliseconds, number, percent, plusMinus, shortDistance, volts } from '../format';
import { codeText, text } from '../language';
import { ellipse95 } from '../map/ellipse';
import type { Motion, Score } from '../protocol/messages';
import { wrapAngle } from '../run/view';
import type { Session } from '../session';
import { type Fact, Facts } from './facts';
import { TeamPanel } from './team_panel';
import { modeWords, whyWords } from '../shell/mission_strip';

export function positionWords(motion: Motion | null): string {
  const ellipse = ellipse95(motion?.covariance ?? null);
  return ellipse ? plusMinus(ellipse.majorM) : text('status.unsure');
}

const scoreFormats: [keyof Score, (value: number | null) => string][] = [
  ['free_iou', (value) => percent(value, 1)],
  ['wall_rmse_m', shortDistance],
  ['solid_called_free', (value) => percent(value, 1)],
  ['objects_found', percent],
  ['pose_error_m', shortDistance],
];

export function StatusPanel({ session }: { session: Session }): JSX.Element {
  const { hello, state, team, motion, time } = session.shown.value.view;
  const link = state?.link;
  const localization = state?.localization;
  const score = state?.score;
  const position: Fact[] = [
    { name: text('status.position'), value: positionWords(motion), help: text('status.sure.help') },
    { name: text('status.heading'), value: degrees(motion && wrapAngle(motion.pose.heading)) },
  ];
  if (localization?.status) {
    const { status } = localization;
    position.push({ name: text('status.localization'), value: codeText('localization', status, status) });
    position.push({ name: text('status.lostProbability'), value: percent(localization.lost_probability) });
  }
  return (
    <>
      <section>
        <h2>{modeWords(state)}</h2>
        <p class="help">{whyWords(state)}</p>
        {(motion || !team) && <Facts facts={position} />}
      </section>
      {team && <TeamPanel team={team} />}
      <section>
        <h2>{text('status.progress')}</h2>
        <Facts
          facts={[
            { name: text('status.coverage'), value: percent(state?.coverage), help: text('status.coverage.help') },
            { name: text('status.unseen'), value: area(state?.unseen_m2) },
            { name: text('status.floor'), value: area(state?.floor_m2) },
            { name: text('status.stops'), value: number(state?.stops), help: text('status.stops.help') },
            { name: text('status.travelled'), value: metres(state?.travelled_m) },
            { name: text('status.time'), value: duration(time) },
            { name: text('status.left'), value: duration(state?.left_s) },
          ]}
        />
      </section>
      {score && (
        <section>
          <h2>{text('status.score')}</h2>
          <Facts
            facts={scoreFormats.map(([key, format]) => ({
              name: text(`score.${key}`),
              value: format(score[key]),
              help: text(`score.${key}.help`),
            }))}
          />
        </section>
      )}
      <section>
        <h2>{text('link.title')}</h2>
        <Facts
          facts={[
            { name: text('link.roundTrip'), value: milliseconds(link?.round_trip_ms), help: text('link.roundTrip.help') },
            { name: text('link.rate'), value: number(link?.frames_per_s) },
            { name: text('link.lost'), value: number(link?.frames_lost) },
            { name: text('link.bad'), value: number(link?.frames_bad), help: text('link.bad.help') },
            { name: text('link.resets'), value: number(link?.resets) },
            { name: text('link.outages'), value: number(link?.outages) },
            { name: text('link.battery'), value: volts(link?.battery_v) },
            { name: text('link.page'), value: milliseconds(session.connection.clock.roundTripMs) },
            { name: text('status.clients'), value: number(state?.clients) },
            { name: text('status.robot'), value: hello ? `${hello.robot} · ${hello.version}` : '–' },
          ]}
        />
      </section>
    </>
  );
}

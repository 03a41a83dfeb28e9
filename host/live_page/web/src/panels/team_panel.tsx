// SPDX-License-Identifier: MIT
import type { JSX } from 'preact';
import { number, percent } from '../format';
import { codeText, text } from '../language';
import { teamColour } from '../map/draw_team';
import { palettes } from '../map/palette';
import type { Team, TeamRobot } from '../protocol/messages';
import { theme } from '../theme';
import { Facts } from './facts';

function standing(robot: TeamRobot): string {
  const presence = codeText('presence', robot.presence, robot.presence);
  const joined = robot.pose ? text('team.joined') : text('team.apart');
  return `${presence} · ${joined} · ${number(robot.stops)} ${text('team.stops')}`;
}

/** The robots of a fleet, and what they know of the source that they look for. */
export function TeamPanel({ team }: { team: Team }): JSX.Element {
  const palette = palettes[theme.value];
  const { source } = team;
  return (
    <>
      <section>
        <h2>{text('team.title')}</h2>
        <ul class="team">
          {team.robots.map((robot, index) => (
            <li key={robot.name}>
              <i class="swatch" style={{ background: teamColour(palette, index) }} />
              <span>{robot.name}</span>
              <span class="help">{standing(robot)}</span>
            </li>
          ))}
        </ul>
      </section>
      {source && (
        <section>
          <h2>{text('source.title')}</h2>
          <Facts
            facts={[
              { name: text('source.verdict'), value: codeText('source.verdict', source.verdict, source.verdict) },
              { name: text('source.none'), value: percent(source.none_probability), help: text('source.none.help') },
            ]}
          />
        </section>
      )}
    </>
  );
}

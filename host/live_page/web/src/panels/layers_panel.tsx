// SPDX-License-Identifier: MIT
import type { JSX } from 'preact';
import { text } from '../language';
import { type LayerName, layerNames } from '../map/layers';
import { palettes } from '../map/palette';
import type { Session } from '../session';
import { theme } from '../theme';

export function LayersPanel({ session }: { session: Session }): JSX.Element {
  const { hello, team } = session.shown.value.view;
  const palette = palettes[theme.value];
  const colours: Record<LayerName, string> = {
    grid: palette.hatch,
    walls: palette.wall,
    trail: palette.estimate,
    odometry: palette.odometry,
    truth: palette.truth,
    sonar: palette.sonar,
    choices: palette.choice,
    hypotheses: palette.hypothesis,
    particles: palette.particles[3]!,
    team: palette.team[0]!,
    source: palette.source,
  };
  const names = layerNames.filter(
    (name) =>
      (name !== 'truth' || hello?.has_truth) &&
      (name !== 'sonar' || hello?.sonar !== null) &&
      (name !== 'team' || team) &&
      (name !== 'source' || team?.source),
  );
  const swatch = (colour: readonly number[] | string, label: string): JSX.Element => (
    <li>
      <i class="swatch" style={{ background: typeof colour === 'string' ? colour : `rgb(${colour.join(',')})` }} />
      {label}
    </li>
  );
  return (
    <section>
      <h2>{text('layers.title')}</h2>
      <div class="layers">
        {names.map((name) => (
          <button
            key={name}
            type="button"
            role="switch"
            class="layer"
            aria-checked={session.layers.value[name]}
            title={name === 'particles' ? text('layer.particles.help') : undefined}
            onClick={() => session.toggleLayer(name)}
          >
            <i class={`swatch swatch-${name}`} style={{ background: colours[name], color: colours[name] }} />
            <span>{text(`layer.${name}`)}</span>
            <i class="switch" />
          </button>
        ))}
      </div>
      <div class="actions">
        <button
          type="button"
          aria-pressed={session.tool.value === 'measure'}
          onClick={() => session.chooseTool('measure')}
        >
          {text('tool.measure')}
        </button>
      </div>
      <ul class="legend">
        {swatch(palette.free, text('legend.free'))}
        {swatch(palette.undecided, text('legend.undecided'))}
        {swatch(palette.occupied, text('legend.occupied'))}
        <li>
          <i class="swatch swatch-hatched" />
          {text('legend.unknown')}
        </li>
        {hello?.sonar && (
          <>
            {swatch(palette.sonar, text('legend.echo'))}
            {swatch(palette.silence, text('legend.silence'))}
            {swatch(palette.noAnswer, text('legend.noAnswer'))}
          </>
        )}
      </ul>
    </section>
  );
}

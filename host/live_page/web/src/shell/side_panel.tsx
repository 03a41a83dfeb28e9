// SPDX-License-Identifier: MIT
import { useSignal } from '@preact/signals';
import type { JSX } from 'preact';
import { text } from '../language';
import { DrivePanel } from '../panels/drive_panel';
import { LayersPanel } from '../panels/layers_panel';
import { LogPanel } from '../panels/log_panel';
import { StatusPanel } from '../panels/status_panel';
import { PlotsPanel } from '../plots/plots_panel';
import type { Session } from '../session';
import { Icon } from './icons';

const panels = {
  drive: DrivePanel,
  status: StatusPanel,
  layers: LayersPanel,
  plots: PlotsPanel,
  log: LogPanel,
};
type PanelName = keyof typeof panels;
const allNames = Object.keys(panels) as PanelName[];

/** Beside the map, or below it on a phone, where a second tap on its tab closes it. */
export function SidePanel({ session }: { session: Session }): JSX.Element {
  const chosen = useSignal<PanelName>('drive');
  const closed = useSignal(false);
  const isOver =
    (session.shownRun.value !== null && !session.isLiveRun.value) ||
    session.shown.value.view.state?.mode === 'ended';
  // Nobody drives a whole fleet: it begins on what shows the team.
  const isFleet = session.shown.value.view.team !== null && session.can.value.size === 0;
  const names = allNames.filter((name) => name !== 'drive' || !(isOver || isFleet));
  const shown = names.includes(chosen.value) ? chosen.value : 'status';
  const Panel = panels[shown];
  const choose = (name: PanelName): void => {
    closed.value = name === shown && !closed.value;
    chosen.value = name;
  };
  return (
    <aside class={closed.value ? 'side side-closed' : 'side'} aria-label={text('tab.all')}>
      <div
        class="tabs"
        role="tablist"
        aria-label={text('tab.all')}
        onKeyDown={(event) => {
          const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
          if (step === undefined) return;
          event.preventDefault();
          const next = names[(names.indexOf(shown) + step + names.length) % names.length]!;
          chosen.value = next;
          document.getElementById(`tab-${next}`)?.focus();
        }}
      >
        {names.map((name) => (
          <button
            key={name}
            type="button"
            role="tab"
            id={`tab-${name}`}
            aria-selected={name === shown}
            aria-controls="panel"
            tabIndex={name === shown ? 0 : -1}
            onClick={() => choose(name)}
          >
            <Icon name={name} />
            <span>{text(`tab.${name}`)}</span>
          </button>
        ))}
      </div>
      <div id="panel" class="panel" role="tabpanel" aria-labelledby={`tab-${shown}`} tabIndex={0}>
        <Panel session={session} />
      </div>
    </aside>
  );
}

// SPDX-License-Identifier: MIT
import { useSignalEffect } from '@preact/signals';
import type { JSX } from 'preact';
import { language, text } from '../language';
import type { Session } from '../session';
import { LiveRegion } from './banners';
import { Header } from './header';
import { MapStage } from './map_stage';
import { MissionStrip } from './mission_strip';
import { SidePanel } from './side_panel';
import { TimelineBar } from './timeline_bar';

export function App({ session }: { session: Session }): JSX.Element {
  useSignalEffect(() => {
    document.documentElement.lang = language.value;
  });
  return (
    <div class="page">
      <a class="skip" href="#map">
        {text('app.skip')}
      </a>
      <Header session={session} />
      <main class="main">
        <MissionStrip session={session} />
        <MapStage session={session} />
        <TimelineBar session={session} />
      </main>
      <SidePanel session={session} />
      <LiveRegion session={session} />
    </div>
  );
}

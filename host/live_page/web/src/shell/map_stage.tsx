// SPDX-License-Identifier: MIT
import { useSignal } from '@preact/signals';
import type { JSX } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { text } from '../language';
import { MapView } from '../map/map_view';
import { positionWords } from '../panels/status_panel';
import type { Session } from '../session';
import { theme } from '../theme';
import { Banners } from './banners';
import { Icon, type IconName } from './icons';

export function MapStage({ session }: { session: Session }): JSX.Element {
  const canvas = useRef<HTMLCanvasElement>(null);
  const map = useRef<MapView | null>(null);
  const scale = useSignal({ length: '', pixels: 0 });
  useEffect(() => {
    map.current = new MapView(canvas.current!, session);
    map.current.onScale = (length, pixels) => (scale.value = { length, pixels });
    return theme.subscribe(() => map.current?.invalidate());
  }, []);
  const tool = session.tool.value;
  const follows = session.follows.value;
  const button = (icon: IconName, label: string, act: () => void, pressed?: boolean): JSX.Element => (
    <button type="button" class={`map-button map-button-${icon}`} title={label} aria-label={label} aria-pressed={pressed} onClick={act}>
      <Icon name={icon} />
    </button>
  );
  return (
    <div class="stage">
      <canvas
        ref={canvas}
        id="map"
        class={tool === 'pan' ? 'map' : 'map map-aims'}
        role="application"
        aria-label={text('map.label')}
        tabIndex={0}
      />
      <Banners session={session} />
      <div class="position" title={text('status.sure.help')}>
        {positionWords(session.shown.value.view.motion)}
      </div>
      <div class="scale" style={{ width: `${scale.value.pixels}px` }} title={text('map.scale')}>
        {scale.value.length}
      </div>
      {tool !== 'pan' && (
        <div class="hint">
          {text(`tool.${tool}.hint`)}{' '}
          <button type="button" class="small" onClick={() => session.chooseTool(tool)}>
            {text('tool.cancel')}
          </button>
        </div>
      )}
      <div class="map-buttons">
        {button(
          'follow',
          text('map.follow'),
          () => {
            session.follows.value = !follows;
            session.onChange();
          },
          follows,
        )}
        {button('fit', text('map.fit'), () => map.current?.fit())}
        {button('minus', text('map.zoomOut'), () => map.current?.zoom(1 / 1.4))}
        {button('plus', text('map.zoomIn'), () => map.current?.zoom(1.4))}
      </div>
    </div>
  );
}

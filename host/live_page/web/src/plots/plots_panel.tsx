// SPDX-License-Identifier: MIT
import type { JSX } from 'preact';
import { degrees, milliseconds, shortDistance } from '../format';
import { text } from '../language';
import type { Sweep } from '../protocol/messages';
import { wrapAngle } from '../run/view';
import type { Session } from '../session';
import { Plot } from './plot';

const degreesPerRadian = 180 / Math.PI;

/** By rising bearing, as plots want it. */
export function sweepByBearing(sweep: Sweep | null | undefined): { bearings: number[]; ranges: (number | null)[] } {
  const pairs = (sweep?.bearings ?? []).map(
    (bearing, index) => [wrapAngle(bearing) * degreesPerRadian, sweep?.ranges_m[index] ?? null] as const,
  );
  pairs.sort((a, b) => a[0] - b[0]);
  return { bearings: pairs.map(([bearing]) => bearing), ranges: pairs.map(([, range]) => range) };
}

export function PlotsPanel({ session }: { session: Session }): JSX.Element {
  const { room, series } = session.shown.value.view;
  const { bearings, ranges } = sweepByBearing(room?.sweep);
  const time = `${text('plot.time')} (s)`;
  return (
    <>
      <Plot
        title={text('plot.sweep')}
        help={text('plot.sweep.help')}
        xLabel={`${text('plot.bearing')} (°)`}
        x={bearings}
        version={room}
        curves={[{ label: text('plot.range'), unit: 'm', values: ranges, dots: true }]}
        summary={`${ranges.filter((range) => range !== null).length} / ${ranges.length}`}
      />
      <Plot
        title={text('plot.odometry')}
        help={text('plot.odometry.help')}
        xLabel={time}
        x={series.time}
        version={series.time.length}
        curves={[
          { label: text('plot.distance'), unit: 'm', values: series.distanceM },
          { label: text('plot.heading'), unit: '°', values: series.headingRad.map((angle) => angle * degreesPerRadian) },
        ]}
        summary={`${shortDistance(series.distanceM.at(-1))}, ${degrees(series.headingRad.at(-1))}`}
      />
      <Plot
        title={text('plot.roundTrip')}
        xLabel={time}
        x={series.time}
        version={series.time.length}
        curves={[{ label: text('link.roundTrip'), unit: 'ms', values: series.roundTripMs }]}
        summary={milliseconds(series.roundTripMs.at(-1))}
      />
    </>
  );
}

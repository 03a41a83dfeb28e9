// SPDX-License-Identifier: MIT
import type { JSX } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import uPlot from 'uplot';
import { language, text } from '../language';
import { theme } from '../theme';

export interface Curve {
  label: string;
  unit: string;
  values: (number | null)[];
  /** Dots instead of a line. */
  dots?: boolean;
}

export interface PlotProps {
  title: string;
  help?: string;
  xLabel: string;
  x: number[];
  curves: Curve[];
  /** Changes with the values. */
  version: unknown;
  /** What somebody who does not see the curve is told. */
  summary: string;
}

const height = 150;
const axisColours = { light: '#47525f', dark: '#b9c3cf' };
const gridColours = { light: 'rgba(40,60,90,.14)', dark: 'rgba(200,215,235,.14)' };
const curveColours = { light: ['#0072b2', '#b34e00'], dark: ['#56b4e9', '#f5a623'] };

/** No curve of the page falls below zero; what is next to nothing, in each unit, is not blown up. */
const leastTop = 0.05;
const fromZero = (_: uPlot, __: number | null, max: number | null): [number, number] => [
  0,
  Math.max(leastTop, max ?? 1) * 1.1,
];
const tickWords = (_: uPlot, ticks: (number | null)[]): string[] =>
  ticks.map((tick) => tick?.toLocaleString(language.value) ?? '');

export function Plot(props: PlotProps): JSX.Element {
  const frame = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const shownTheme = theme.value;
  const labels = [props.xLabel, ...props.curves.map(({ label }) => label)].join('|');
  const data = [props.x, ...props.curves.map(({ values }) => values)] as uPlot.AlignedData;
  useEffect(() => {
    const element = frame.current!;
    const colours = curveColours[shownTheme];
    const axis = (label: string, scale: string, extra: Partial<uPlot.Axis> = {}): uPlot.Axis => ({
      label,
      scale,
      labelSize: 18,
      labelFont: '12px system-ui',
      font: '11px system-ui',
      stroke: axisColours[shownTheme],
      grid: { stroke: gridColours[shownTheme], width: 1 },
      ticks: { show: false },
      values: tickWords,
      ...extra,
    });
    const created = new uPlot(
      {
        width: Math.max(160, element.clientWidth),
        height,
        legend: { show: false },
        cursor: { show: false },
        scales: {
          x: { time: false },
          ...Object.fromEntries(props.curves.map(({ unit }) => [unit, { range: fromZero }])),
        },
        axes: [
          axis(props.xLabel, 'x', { size: 28 }),
          ...props.curves.map((curve, index) =>
            axis(`${curve.label} (${curve.unit})`, curve.unit, {
              size: 40,
              side: index === 0 ? 3 : 1,
              stroke: props.curves.length > 1 ? colours[index]! : axisColours[shownTheme],
              grid: { show: index === 0, stroke: gridColours[shownTheme], width: 1 },
            }),
          ),
        ],
        series: [
          {},
          ...props.curves.map((curve, index) => ({
            label: curve.label,
            scale: curve.unit,
            stroke: colours[index]!,
            width: 2,
            dash: index === 0 ? [] : [6, 4],
            ...(curve.dots ? { paths: () => null, points: { show: true, size: 5, fill: colours[index]! } } : {}),
          })),
        ],
      },
      data,
      element,
    );
    plot.current = created;
    const observer = new ResizeObserver(() => created.setSize({ width: Math.max(160, element.clientWidth), height }));
    observer.observe(element);
    return () => {
      observer.disconnect();
      created.destroy();
      plot.current = null;
    };
  }, [shownTheme, labels]);
  useEffect(() => plot.current?.setData(data), [props.version]);
  const isEmpty = props.x.length === 0;
  return (
    <section>
      <h2>{props.title}</h2>
      {props.help && <p class="help">{props.help}</p>}
      {isEmpty && <p class="help">{text('plot.none')}</p>}
      <div ref={frame} class={isEmpty ? 'plot plot-empty' : 'plot'} role="img" aria-label={`${props.title}. ${props.summary}`} />
    </section>
  );
}

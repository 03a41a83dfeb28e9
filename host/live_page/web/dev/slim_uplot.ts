// SPDX-License-Identifier: MIT
import type { Plugin } from 'vite';

/** Paths to what no plot of this page draws, and what is there instead; the bundler drops what they led to. */
const shortcuts: [string, string][] = [
  // Steps, bars and splines.
  ['(paths.stepped = stepped);', ''],
  ['(paths.bars    = bars);', ''],
  ['(paths.spline  = monotoneCubic);', ''],
  // Calendar dates.
  ['= genTimeStuffs(1);', '= [[], [], null];'],
  ['= genTimeStuffs(1e-3);', '= [[], [], null];'],
  ['(ms == 1 ? timeAxisSplitsMs(_tzDate) : timeAxisSplitsS(_tzDate))', 'null'],
  ['timeAxisVals(_tzDate, timeAxisStamps((ms == 1 ? _timeAxisStampsMs : _timeAxisStampsS), _fmtDate))', 'null'],
  ['timeSeriesVal(_tzDate, timeSeriesStamp(_timeSeriesStamp, _fmtDate))', 'null'],
  ['timeSeriesVal(_tzDate, timeSeriesStamp(sv, _fmtDate))', 'sv'],
  ['timeAxisVals(_tzDate, timeAxisStamps(av, _fmtDate))', 'av'],
  ['timeAxisVal(_tzDate, av)', 'av'],
  ['uPlot.fmtDate = fmtDate;', ''],
  ['uPlot.tzDate  = tzDate;', ''],
  // Helpers for its users.
  ['uPlot.join = join;', ''],
  ['uPlot.rangeLog = rangeLog;', ''],
  ['uPlot.rangeAsinh = rangeAsinh;', ''],
];

export function slimUplot(): Plugin {
  return {
    name: 'slim-uplot',
    transform(code, id) {
      if (!id.includes('uPlot.esm.js')) return null;
      return shortcuts.reduce((slimmer, [from, to]) => {
        if (!slimmer.includes(from)) this.error(`uPlot has changed: no ${from}`);
        return slimmer.replace(from, to);
      }, code);
    },
  };
}

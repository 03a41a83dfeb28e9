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
  // Legend, cursor, and what the mouse does to them.
  ['const showLegend = legend.show;', 'const showLegend = false;'],
  ['const showCursor =                cursor.show;', 'const showCursor = false;'],
  ['events.mousedown = mouseDown;', ''],
  ['events.mousemove = mouseMove;', ''],
  ['events.mouseup = mouseUp;', ''],
  ['events.dblclick = dblClick;', ''],
  ['function updateCursor(src, _fire, _pub) {', 'function updateCursor() { return;'],
  ['function initLegendRow(s, i) {', 'function initLegendRow() { return;'],
  ['function setLegendValues(sidx, idx) {', 'function setLegendValues() { return;'],
  // Logarithmic scales.
  ['sc.distr == 3 ? logAxisSplits : sc.distr == 4 ? asinhAxisSplits : numAxisSplits', 'numAxisSplits'],
  ['(          sc.distr >= 3 && sc.log == 10 ? log10AxisValsFilt : sc.distr == 3 && sc.log == 2 ? log2AxisValsFilt : retArg1)', 'retArg1'],
  ['function rangeLog(min, max, base, fullMags) {', 'function rangeLog(min, max) { return [min, max];'],
  ['function rangeAsinh(min, max, base, fullMags) {', 'function rangeAsinh(min, max) { return [min, max];'],
  // Bands between two curves.
  ['function bandFillClipDirs(self, seriesIdx) {', 'function bandFillClipDirs() { return [0, 0];'],
  ['function clipBandLine(self, seriesIdx, idx0, idx1, strokePath, clipDir) {', 'function clipBandLine() { return null;'],
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

// SPDX-License-Identifier: MIT
import type { Plugin } from 'vite';

/** What uPlot exports to its users and no plot of this page uses; the bundler drops what it leads to. */
const unused = [
  '(paths.stepped = stepped);',
  '(paths.bars    = bars);',
  '(paths.spline  = monotoneCubic);',
  'uPlot.fmtDate = fmtDate;',
  'uPlot.tzDate  = tzDate;',
  'uPlot.join = join;',
  'uPlot.rangeLog = rangeLog;',
  'uPlot.rangeAsinh = rangeAsinh;',
];

export function slimUplot(): Plugin {
  return {
    name: 'slim-uplot',
    transform(code, id) {
      if (!id.includes('uPlot.esm.js')) return null;
      return unused.reduce((slimmer, statement) => {
        if (!slimmer.includes(statement)) this.error(`uPlot has changed: no ${statement}`);
        return slimmer.replace(statement, '');
      }, code);
    },
  };
}

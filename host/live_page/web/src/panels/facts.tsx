// SPDX-License-Identifier: MIT
import type { JSX } from 'preact';

export interface Fact {
  name: string;
  value: string;
  help?: string;
}

/** Names and values, two columns. */
export function Facts({ facts }: { facts: Fact[] }): JSX.Element {
  return (
    <dl class="facts">
      {facts.map(({ name, value, help }) => (
        <div key={name} title={help}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}

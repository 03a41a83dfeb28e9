// SPDX-License-Identifier: MIT
import type { Point, Pose } from '../protocol/messages';

/** What a press on the map means. */
export type Tool = 'pan' | 'go' | 'pose' | 'box' | 'measure';

/** What a tool shows on the map while it is used. */
export interface ToolMarks {
  measure: Point[];
  pose: Pose | null;
}

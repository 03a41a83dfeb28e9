// SPDX-License-Identifier: MIT
import type { Team } from '../protocol/messages';
import type { Camera } from './camera';
import { drawRobot } from './draw_robot';
import { type Context, strokeWithHalo, traceTrail } from './draw_shapes';
import type { LabelSpace } from './label_space';
import type { Palette } from './palette';

const labelGap = 22;

export function teamColour(palette: Palette, index: number): string {
  return palette.team[index % palette.team.length]!;
}

/** Trails, claimed places and robots, each in its robot's colour; one that is silent is pale. */
export function drawTeam(context: Context, camera: Camera, team: Team, palette: Palette): void {
  team.robots.forEach((robot, index) => {
    if (!robot.pose) return;
    const colour = teamColour(palette, index);
    context.globalAlpha = robot.presence === 'alive' ? 1 : 0.45;
    context.strokeStyle = colour;
    context.lineJoin = context.lineCap = 'round';
    context.lineWidth = 2.5;
    context.beginPath();
    traceTrail(context, camera, robot.trail, false);
    context.stroke();
    if (robot.claim) {
      const [x, y] = camera.toScreen(...robot.claim);
      context.lineWidth = 2;
      context.setLineDash([3, 6]);
      context.beginPath();
      context.moveTo(...camera.toScreen(robot.pose.x, robot.pose.y));
      context.lineTo(x, y);
      strokeWithHalo(context, palette.halo);
      context.setLineDash([]);
      context.beginPath();
      context.arc(x, y, 9, 0, 2 * Math.PI);
      strokeWithHalo(context, palette.halo);
    }
    drawRobot(context, camera, robot.pose, robot.radius_m, palette, colour);
  });
  context.globalAlpha = 1;
}

export function labelTeam(space: LabelSpace, camera: Camera, team: Team): void {
  for (const robot of team.robots) {
    if (!robot.pose) continue;
    const [x, y] = camera.toScreen(robot.pose.x, robot.pose.y);
    space.place(robot.name, x, [y - labelGap, y + labelGap], true);
  }
}

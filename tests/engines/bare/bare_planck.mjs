#!/usr/bin/env node
// A stack of blocks in Planck by its own calls alone. What is not set stays as the library has it.

import { inPackage, printAngles, readQuestion } from './question.mjs';

const { Box, Settings, World } = await import(inPackage('planck/dist/planck.mjs'));
const question = readQuestion();
const { set, friction, reach } = question;
if ('lengthUnit' in set) Settings.lengthUnitsPerMeter = set.lengthUnit;
if ('velocityThreshold' in set) Settings.velocityThreshold = set.velocityThreshold;
const world = new World({ allowSleep: false });
if ('warmStarting' in set) world.setWarmStarting(set.warmStarting !== 0);
if ('continuousPhysics' in set) world.setContinuousPhysics(set.continuousPhysics !== 0);

// The friction of two fixtures is the root of their product, so that both have the coefficient itself.
const add = (body, width, height) => {
  const shape = new Box(width / 2, height / 2);
  if ('polygonRadius' in set) shape.m_radius = set.polygonRadius;
  body.createFixture({ shape, friction, restitution: set.restitution ?? 0 });
  return body;
};
add(world.createBody({ position: { x: 0, y: -reach } }), 2 * reach, 2 * reach);
const bodies = question.blocks.map(({ x, y, angle, width, height, mass, aboutZ }) => {
  const body = add(world.createDynamicBody({ position: { x, y }, angle: -angle }), width, height);
  body.setMassData({ mass, center: { x: 0, y: 0 }, I: aboutZ });
  return body;
});
printAngles(question, (x, y) => {
  world.setGravity({ x, y });
  world.step(question.dt, set.velocityIterations ?? 8, set.positionIterations ?? 3);
}, (k) => -bodies[k].getAngle());

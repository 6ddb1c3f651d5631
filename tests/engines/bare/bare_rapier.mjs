#!/usr/bin/env node
// A stack of blocks in Rapier by its own calls alone. What is not set stays as the library has it.

import { inPackage, printAngles, readQuestion } from './question.mjs';

const { default: rapier } = await import(inPackage('@dimforge/rapier2d-deterministic-compat/dist/rapier.mjs'));
await rapier.init();
const question = readQuestion();
const { set, reach } = question;
const world = new rapier.World({ x: 0, y: 0 });
const chosen = world.integrationParameters;
chosen.dt = question.dt;
const setters = {
  lengthUnit: (value) => { chosen.lengthUnit = value; },
  numSolverIterations: (value) => { chosen.numSolverIterations = value; },
  numInternalPgsIterations: (value) => { chosen.numInternalPgsIterations = value; },
  contact_natural_frequency: (value) => { chosen.contact_natural_frequency = value; },
};
for (const [name, value] of Object.entries(set)) setters[name](value);

const box = (width, height) => rapier.ColliderDesc.cuboid(width / 2, height / 2).setFriction(question.friction);
world.createCollider(box(2 * reach, 2 * reach), world.createRigidBody(rapier.RigidBodyDesc.fixed().setTranslation(0, -reach)));
const bodies = question.blocks.map(({ x, y, angle, width, height, mass, aboutZ }) => {
  const body = world.createRigidBody(rapier.RigidBodyDesc.dynamic().setTranslation(x, y).setRotation(-angle).setCanSleep(false));
  world.createCollider(box(width, height).setMassProperties(mass, { x: 0, y: 0 }, aboutZ), body);
  return body;
});
printAngles(question, (x, y) => {
  world.gravity = { x, y };
  world.step();
}, (k) => -bodies[k].rotation());

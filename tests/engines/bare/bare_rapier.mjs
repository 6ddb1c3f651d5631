#!/usr/bin/env node
// A stack of blocks in Rapier by its own calls alone. What is not set stays as the library has it. Two parameters of the
// library have no call in JavaScript, and are written where the library keeps them.

import { inPackage, printAngles, readQuestion } from './question.mjs';

let memory;
const { instantiate } = WebAssembly;
WebAssembly.instantiate = async (...given) => {
  const made = await instantiate(...given);
  memory = made.instance?.exports.memory ?? memory;  // node makes instances of its own
  return made;
};
const { default: rapier } = await import(inPackage('@dimforge/rapier2d-deterministic-compat/dist/rapier.mjs'));
await rapier.init();
const question = readQuestion();
const { set, reach } = question;
const world = new rapier.World({ x: 0, y: 0 });
const chosen = world.integrationParameters;
chosen.dt = question.dt;
/** The parameters as 32-bit words: four whole numbers that follow each other are known by three of them. */
const words = (Kind) => {
  const list = new Kind(memory.buffer, chosen.raw.__wbg_ptr, 19);
  const [iterations, pgs, , ccd] = new Uint32Array(memory.buffer, chosen.raw.__wbg_ptr, 19).slice(13, 17);
  const wanted = [chosen.numSolverIterations, chosen.numInternalPgsIterations, chosen.maxCcdSubsteps];
  if (String([iterations, pgs, ccd]) !== String(wanted)) throw new Error('the parameters of this version lie elsewhere');
  return list;
};
const setters = {
  activeHooks: () => {},
  num_internal_stabilization_iterations: (value) => { words(Uint32Array)[15] = value; },
  warmstart_coefficient: (value) => { words(Float32Array)[7] = value; },
  lengthUnit: (value) => { chosen.lengthUnit = value; },
  numSolverIterations: (value) => { chosen.numSolverIterations = value; },
  numInternalPgsIterations: (value) => { chosen.numInternalPgsIterations = value; },
  contact_natural_frequency: (value) => { chosen.contact_natural_frequency = value; },
};
for (const [name, value] of Object.entries(set)) setters[name](value);

const box = (width, height) => rapier.ColliderDesc.cuboid(width / 2, height / 2).setFriction(question.friction)
  .setActiveHooks(set.activeHooks ? rapier.ActiveHooks.FILTER_INTERSECTION_PAIRS : rapier.ActiveHooks.NONE);
world.createCollider(box(2 * reach, 2 * reach), world.createRigidBody(rapier.RigidBodyDesc.fixed().setTranslation(0, -reach)));
const bodies = question.blocks.map(({ x, y, angle, width, height, mass, aboutZ, right = 0, up = 0, spin = 0 }) => {
  const body = world.createRigidBody(rapier.RigidBodyDesc.dynamic().setTranslation(x, y).setRotation(-angle)
    .setLinvel(right, up).setAngvel(-spin).setCanSleep(false));
  world.createCollider(box(width, height).setMassProperties(mass, { x: 0, y: 0 }, aboutZ), body);
  return body;
});
printAngles(question, (x, y) => {
  world.gravity = { x, y };
  world.step(undefined, { filterContactPair: () => null, filterIntersectionPair: () => true });
}, (k) => -bodies[k].rotation());

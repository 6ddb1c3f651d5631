#!/usr/bin/env node
// A stack of blocks in Rapier 3D by its own calls alone. What is not set stays as the library has it. `locks 1` holds back motion out
// of the plane, 2 turns out of it, 3 both, 0 nothing; turns are held back where it is left out. `along 1` prints places in the place
// of angles, `borne 1` what presses on the ground and `borne 2` what rubs on it, N.

import { inPackage, printAngles, readQuestion } from './question.mjs';

const { default: rapier } = await import(inPackage('@dimforge/rapier3d-compat/dist/rapier.mjs'));
await rapier.init();
const question = readQuestion();
const { set, reach, locks = 2, borne = 0 } = question;
const world = new rapier.World({ x: 0, y: 0, z: 0 });
const chosen = world.integrationParameters;
chosen.dt = question.dt;
const setters = {
  activeHooks: () => {},
  lengthUnit: (value) => { chosen.lengthUnit = value; },
  numSolverIterations: (value) => { chosen.numSolverIterations = value; },
  numInternalPgsIterations: (value) => { chosen.numInternalPgsIterations = value; },
  contact_natural_frequency: (value) => { chosen.contact_natural_frequency = value; },
};
for (const [name, value] of Object.entries(set)) setters[name](value);

const add = (wanted, { width, height, depth }, more = (shape) => shape) => {
  const body = world.createRigidBody(wanted);
  const shape = rapier.ColliderDesc.cuboid(width / 2, height / 2, depth / 2).setFriction(question.friction);
  if (set.activeHooks) shape.setActiveHooks(rapier.ActiveHooks.FILTER_INTERSECTION_PAIRS);
  world.createCollider(more(shape), body);
  return body;
};
const size = 2 * reach;
const ground = add(rapier.RigidBodyDesc.fixed().setTranslation(0, -reach, 0), { width: size, height: size, depth: size });
const bodies = question.blocks.map((block) => {
  const wanted = rapier.RigidBodyDesc.dynamic().setTranslation(block.x, block.y, 0).setCanSleep(false)
    .setRotation({ x: 0, y: 0, z: -Math.sin(block.angle / 2), w: Math.cos(block.angle / 2) })
    .setLinvel(block.right ?? 0, block.up ?? 0, 0).setAngvel({ x: 0, y: 0, z: -(block.spin ?? 0) });
  if (locks & 1) wanted.enabledTranslations(true, true, false);
  if (locks & 2) wanted.enabledRotations(false, false, true);
  const { mass, aboutX, aboutY, aboutZ } = block;
  return add(wanted, block, (shape) => shape.setMassProperties(mass, { x: 0, y: 0, z: 0 },
    { x: aboutX, y: aboutY, z: aboutZ }, { x: 0, y: 0, z: 0, w: 1 }));
});
/** Sum over the points in which a body touches the ground, by what the manifold tells of each. */
const onGround = (body, tell) => {
  let sum = 0;
  world.contactPair(ground.collider(0), body.collider(0), (manifold) => {
    for (let i = 0; i < manifold.numContacts(); ++i) sum += tell(manifold, i) / question.dt;
  });
  return sum;
};
const told = [undefined, (manifold, i) => manifold.contactImpulse(i),
  (manifold, i) => Math.hypot(manifold.contactTangentImpulseX(i), manifold.contactTangentImpulseY(i))][borne];
const hooks = set.activeHooks ? { filterContactPair: () => null, filterIntersectionPair: () => true } : undefined;
printAngles(question, (x, y) => {
  world.gravity = { x, y, z: 0 };
  world.step(undefined, hooks);
}, (k) => {
  if (told) return onGround(bodies[k], told);
  if (question.along) return bodies[k].translation().x;
  const { z, w } = bodies[k].rotation();
  return -2 * Math.atan2(z, w);
});

#!/usr/bin/env node
// A stack of blocks in cannon-es by its own calls alone. What is not set stays as the library has it.

import { inPackage, printAngles, readQuestion } from './question.mjs';

const { Body, Box, Plane, Vec3, World } = await import(inPackage('cannon-es/dist/cannon-es.js'));
const question = readQuestion();
const { set } = question;
const world = new World();
for (const name of ['iterations', 'tolerance']) if (name in set) world.solver[name] = set[name];
const surface = world.defaultContactMaterial;
surface.friction = question.friction;
surface.restitution = set.restitution ?? 0;
for (const name of Object.keys(set)) if (name in surface) surface[name] = set[name];

const ground = new Body({ shape: new Plane(), mass: 0 });
ground.quaternion.set(-Math.SQRT1_2, 0, 0, Math.SQRT1_2);
world.addBody(ground);
const bodies = question.blocks.map((block) => {
  const body = new Body({
    shape: new Box(new Vec3(block.width / 2, block.height / 2, block.depth / 2)), mass: block.mass, linearDamping: 0, angularDamping: 0,
  });
  body.position.set(block.x, block.y, 0);
  body.quaternion.set(0, 0, Math.sin(-block.angle / 2), Math.cos(block.angle / 2));
  body.linearFactor.set(1, 1, 0);
  body.angularFactor.set(0, 0, 1);
  world.addBody(body);
  body.invInertia.set(1 / block.aboutX, 1 / block.aboutY, 1 / block.aboutZ);
  body.updateInertiaWorld(true);
  return body;
});
printAngles(question, (x, y) => {
  world.gravity.set(x, y, 0);
  world.step(question.dt);
}, (k) => -2 * Math.atan2(bodies[k].quaternion.z, bodies[k].quaternion.w));

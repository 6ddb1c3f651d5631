#!/usr/bin/env node
// A stack of blocks in Matter.js by its own calls alone. What is not set stays as the library has it. One word more: with `along 1` it
// prints places along the ground, m, in the place of angles.

import { inPackage, printAngles, readQuestion } from './question.mjs';

const { Bodies, Body, Composite, Engine } = (await import(inPackage('matter-js/build/matter.js'))).default;
const question = readQuestion();
const { set, friction } = question;
const pixel = set.lengthUnit ?? 0.01;
const long = (metres) => metres * (1 / pixel);
const milliseconds = 1000 * question.dt;
const { positionIterations = 6, velocityIterations = 4 } = set;
const engine = Engine.create({ positionIterations, velocityIterations });

const add = (x, y, width, height, isStatic) => {
  const body = Bodies.rectangle(long(x), long(y), long(width), long(height), { isStatic });
  // The least friction of two bodies holds, and what is static has 1 at first.
  Object.assign(body, { friction, frictionAir: 0, restitution: set.restitution ?? 0, deltaTime: milliseconds });
  for (const name of ['slop', 'frictionStatic']) if (name in set) body[name] = set[name];
  Composite.add(engine.world, body);
  return body;
};
add(0, -question.reach, 2 * question.reach, 2 * question.reach, true);
const bodies = question.blocks.map((block) => {
  const body = add(block.x, block.y, block.width, block.height, false);
  Body.setMass(body, block.mass);
  Body.setInertia(body, block.aboutZ * (set.inertiaScale ?? 4) * (1 / pixel) ** 2);
  Body.setAngle(body, -block.angle);
  Body.setVelocity(body, { x: long(block.right ?? 0) / 60, y: long(block.up ?? 0) / 60 });
  Body.setAngularVelocity(body, -(block.spin ?? 0) / 60);
  return body;
});
printAngles(question, (x, y) => {
  Object.assign(engine.gravity, { x, y, scale: 1e-6 * (1 / pixel) });
  Engine.update(engine, milliseconds);
}, (k) => (question.along ? bodies[k].position.x * pixel : -bodies[k].angle));

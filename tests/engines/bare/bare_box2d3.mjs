#!/usr/bin/env node
// A stack of blocks in Box2D 3 by its own classes alone. What is not set stays as the library has it. `angleByLibrary 1` turns bodies
// by the library's own sine and cosine, b2MakeRot.

import { inPackage, printAngles, readQuestion } from './question.mjs';

const { default: load } = await import(inPackage('box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe.mjs'));
const box2d = await load({ pthreadCount: 0 });
const question = readQuestion();
const { set, friction, reach } = question;
const definition = box2d.b2DefaultWorldDef();
definition.enableSleep = false;
const { enableContinuous = 1, contactHertz = 30, contactDampingRatio = 10, contactSpeed = 3, subStepCount = 4 } = set;
definition.enableContinuous = enableContinuous !== 0;
for (const name of ['restitutionThreshold', 'maximumLinearSpeed']) if (name in set) definition[name] = set[name];
const world = new box2d.World(definition);
world.SetContactTuning(contactHertz, contactDampingRatio, contactSpeed);
if ('enableWarmStarting' in set) world.EnableWarmStarting(set.enableWarmStarting !== 0);
if ('enableSpeculative' in set) world.EnableSpeculative(set.enableSpeculative !== 0);
const vector = (x, y) => new box2d.b2Vec2(x, y);

const add = (type, { x, y, angle, width, height }) => {
  const wanted = box2d.b2DefaultBodyDef();
  wanted.type = box2d.b2BodyType[type];
  wanted.position = vector(x, y);
  if (question.angleByLibrary) wanted.rotation = box2d.b2MakeRot(-angle);
  else [wanted.rotation.c, wanted.rotation.s] = [Math.cos(angle), Math.sin(-angle)];
  const body = world.CreateBody(wanted);
  const surface = box2d.b2DefaultShapeDef();
  surface.density = 1 / (width * height);
  // The friction of two shapes is the root of their product, so that both have the coefficient itself.
  surface.material.friction = friction;
  surface.material.restitution = set.restitution ?? 0;
  body.CreatePolygonShape(surface, box2d.b2MakeBox(width / 2, height / 2));
  return body;
};
add('b2_staticBody', { x: 0, y: -reach, angle: 0, width: 2 * reach, height: 2 * reach });
const bodies = question.blocks.map((block) => {
  const body = add('b2_dynamicBody', block);
  const mass = new box2d.b2MassData();
  [mass.mass, mass.rotationalInertia] = [block.mass, block.aboutZ];
  body.SetMassData(mass);
  body.SetLinearVelocity(vector(block.right ?? 0, block.up ?? 0));
  body.SetAngularVelocity(-(block.spin ?? 0));
  return body;
});
printAngles(question, (x, y) => {
  world.SetGravity(vector(x, y));
  world.Step(question.dt, subStepCount);
}, (k) => {
  const { c, s } = bodies[k].GetRotation();
  return -Math.atan2(s, c);
});

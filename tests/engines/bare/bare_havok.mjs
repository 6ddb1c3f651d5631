#!/usr/bin/env node
// A stack of blocks in Havok by its own calls alone. What is not set stays as the library has it. One word more: with `along 1` it
// prints places along the ground, m, in the place of angles.

import { readFileSync } from 'node:fs';
import { inPackage, printAngles, readQuestion } from './question.mjs';

const folder = '@babylonjs/havok/lib/esm';
const { default: load } = await import(inPackage(`${folder}/HavokPhysics_es.js`));
const havok = await load({ wasmBinary: readFileSync(inPackage(`${folder}/HavokPhysics.wasm`)) });
const question = readQuestion();
const [, world] = havok.HP_World_Create();
if ('idealStepTime' in question.set) havok.HP_World_SetIdealStepTime(world, question.set.idealStepTime);

const add = (type, block, place, angle) => {
  const [, shape] = havok.HP_Shape_CreateBox([0, 0, 0], [0, 0, 0, 1], [block.width, block.height, block.depth]);
  const { MAXIMUM } = havok.MaterialCombine;
  havok.HP_Shape_SetMaterial(shape, [question.friction, question.friction, 0, MAXIMUM, MAXIMUM]);
  const [, body] = havok.HP_Body_Create();
  havok.HP_Body_SetShape(body, shape);
  havok.HP_Body_SetMotionType(body, type);
  havok.HP_Body_SetQTransform(body, [place, [0, 0, Math.sin(-angle / 2), Math.cos(angle / 2)]]);
  havok.HP_World_AddBody(world, body, false);
  return body;
};
const { STATIC, DYNAMIC } = havok.MotionType;
const size = 2 * question.reach;
add(STATIC, { width: size, height: size, depth: size }, [0, -question.reach, 0], 0);
const bodies = question.blocks.map((block) => {
  const body = add(DYNAMIC, block, [block.x, block.y, 0], block.angle);
  // The moments are those of one kilogram.
  const inertia = [block.aboutX / block.mass, block.aboutY / block.mass, block.aboutZ / block.mass];
  havok.HP_Body_SetMassProperties(body, [[0, 0, 0], block.mass, inertia, [0, 0, 0, 1]]);
  havok.HP_Body_SetLinearDamping(body, 0);
  havok.HP_Body_SetAngularDamping(body, 0);
  havok.HP_Body_SetActivationControl(body, havok.ActivationControl.ALWAYS_ACTIVE);
  havok.HP_Body_SetLinearVelocity(body, [block.right ?? 0, block.up ?? 0, 0]);
  havok.HP_Body_SetAngularVelocity(body, [0, 0, -(block.spin ?? 0)]);
  return body;
});
printAngles(question, (x, y) => {
  havok.HP_World_SetGravity(world, [x, y, 0]);
  havok.HP_World_Step(world, question.dt);
}, (k) => {
  const [, [[x], [, , z, w]]] = havok.HP_Body_GetQTransform(bodies[k]);
  return question.along ? x : -2 * Math.atan2(z, w);
});

#!/usr/bin/env node
// A stack of blocks in ammo.js by its own calls alone. What is not set stays as the library has it. `borne 1` prints
// what presses on the ground in the place of angles, N, and `borne 2` how many calls of a contact point tell of what rubs.

import { inPackage, printAngles, readQuestion } from './question.mjs';

const { default: load } = await import(inPackage('ammojs3/dist/ammo.wasm.js'));
const ammo = await load();
const question = readQuestion();
const { set, reach, borne = 0 } = question;

const configuration = new ammo.btDefaultCollisionConfiguration();
const dispatcher = new ammo.btCollisionDispatcher(configuration);
const world = new ammo.btDiscreteDynamicsWorld(dispatcher, new ammo.btDbvtBroadphase(),
  new ammo.btSequentialImpulseConstraintSolver(), configuration);
const solver = world.getSolverInfo();
const setters = {
  numIterations: (value) => solver.set_m_numIterations(value),
  splitImpulsePenetrationThreshold: (value) => solver.set_m_splitImpulsePenetrationThreshold(value),
};
for (const [name, value] of Object.entries(set)) setters[name](value);

// The friction of two bodies is the product of theirs, so that each has the root.
const add = ({ width, height, depth, mass, x, y, angle }, inertia) => {
  const shape = new ammo.btBoxShape(new ammo.btVector3(width / 2, height / 2, depth / 2));
  const body = new ammo.btRigidBody(new ammo.btRigidBodyConstructionInfo(mass, null, shape, inertia));
  const rotation = new ammo.btQuaternion(0, 0, 0, 1);
  rotation.setRotation(new ammo.btVector3(0, 0, 1), -angle);
  body.setCenterOfMassTransform(new ammo.btTransform(rotation, new ammo.btVector3(x, y, 0)));
  body.setFriction(Math.sqrt(question.friction));
  world.addRigidBody(body);
  return body;
};
const size = 2 * reach;
add({ width: size, height: size, depth: size, mass: 0, x: 0, y: -reach, angle: 0 }, new ammo.btVector3(0, 0, 0));
const bodies = question.blocks.map((block) => {
  const body = add(block, new ammo.btVector3(block.aboutX, block.aboutY, block.aboutZ));
  body.setLinearFactor(new ammo.btVector3(1, 1, 0));
  body.setAngularFactor(new ammo.btVector3(0, 0, 1));
  body.setActivationState(4);  // it is not put to sleep
  return body;
});
const pressing = () => {
  let sum = 0;
  for (let pair = 0; pair < dispatcher.getNumManifolds(); ++pair) {
    const manifold = dispatcher.getManifoldByIndexInternal(pair);
    for (let i = 0; i < manifold.getNumContacts(); ++i) sum += manifold.getContactPoint(i).getAppliedImpulse() / question.dt;
  }
  return sum;
};
const rubbing = () => Object.getOwnPropertyNames(ammo.btManifoldPoint.prototype).filter((name) => /impulse.*lateral|friction/i.test(name)).length;
const told = [undefined, pressing, rubbing][borne];
printAngles(question, (x, y) => {
  world.setGravity(new ammo.btVector3(x, y, 0));
  world.stepSimulation(question.dt, 0);
}, (k) => {
  if (told) return told();
  const rotation = bodies[k].getWorldTransform().getRotation();
  return -2 * Math.atan2(rotation.z(), rotation.w());
});

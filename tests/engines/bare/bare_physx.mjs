#!/usr/bin/env node
// A stack of blocks in PhysX by its own calls alone. What is not set stays as the library has it. Two words more:
//
//   bits 1    (by so many last bits is an element of the quaternion that turns the ground larger)
//   along 1   (the output is centres' x, m, in place of angles)

import { readFileSync } from 'node:fs';
import { inPackage, printAngles, readQuestion } from './question.mjs';

// The package's build knows browsers alone.
const wasmBinary = readFileSync(inPackage('physx-js-webidl/physx-js-webidl.wasm'));
const question = readQuestion();
const { process } = globalThis;
globalThis.process = undefined;
globalThis.window = globalThis;
const { default: load } = await import(inPackage('physx-js-webidl/physx-js-webidl.mjs'));
const px = await load({ wasmBinary });
globalThis.process = process;

const { set } = question;
const physics = px.CreatePhysics(px.PHYSICS_VERSION,
  px.CreateFoundation(px.PHYSICS_VERSION, new px.PxDefaultAllocator(), new px.PxDefaultErrorCallback()), new px.PxTolerancesScale());
const described = new px.PxSceneDesc(physics.getTolerancesScale());
described.cpuDispatcher = px.DefaultCpuDispatcherCreate(0);
described.filterShader = px.DefaultFilterShader();
if (question.solver === 'tgs') described.solverType = px.PxSolverTypeEnum.eTGS;
for (const name of ['frictionOffsetThreshold', 'frictionCorrelationDistance']) if (name in set) described[name] = set[name];
described.flags.raise(px.PxSceneFlagEnum.eENABLE_ENHANCED_DETERMINISM);
const scene = physics.createScene(described);

const material = physics.createMaterial(question.friction, question.friction, 0);
const shape = (geometry) => {
  const made = physics.createShape(geometry, material, true, new px.PxShapeFlags(px.PxShapeFlagEnum.eSIMULATION_SHAPE));
  made.setSimulationFilterData(new px.PxFilterData(1, 1, 0, 0));
  return made;
};
const pose = (x, y, turn) => new px.PxTransform(new px.PxVec3(x, y, 0), new px.PxQuat(0, 0, Math.sin(turn / 2), Math.cos(turn / 2)));
const quarter = Math.fround(Math.SQRT1_2);
const facingUp = new px.PxQuat(0, 0, quarter, quarter + (question.bits ?? 0) * 2 ** -24);
const ground = physics.createRigidStatic(new px.PxTransform(new px.PxVec3(0, 0, 0), facingUp));
ground.attachShape(shape(new px.PxPlaneGeometry()));
scene.addActor(ground);
const bodies = question.blocks.map((block) => {
  const body = physics.createRigidDynamic(pose(block.x, block.y, -block.angle));
  body.attachShape(shape(new px.PxBoxGeometry(block.width / 2, block.height / 2, block.depth / 2)));
  body.setMass(block.mass);
  body.setMassSpaceInertiaTensor(new px.PxVec3(block.aboutX, block.aboutY, block.aboutZ));
  body.setLinearDamping(0);
  body.setAngularDamping(0);
  body.setSleepThreshold(0);
  body.setSolverIterationCounts(set.minPositionIters ?? 4, set.minVelocityIters ?? 1);
  for (const lock of ['eLOCK_LINEAR_Z', 'eLOCK_ANGULAR_X', 'eLOCK_ANGULAR_Y'])
    body.setRigidDynamicLockFlag(px.PxRigidDynamicLockFlagEnum[lock], true);
  scene.addActor(body);
  return body;
});
printAngles(question, (x, y) => {
  scene.setGravity(new px.PxVec3(x, y, 0));
  scene.simulate(question.dt);
  scene.fetchResults(true);
}, (k) => {
  const { p, q } = bodies[k].getGlobalPose();
  if (question.along) return p.x;
  const z = q.z;
  return -2 * Math.atan2(z, q.w);
});

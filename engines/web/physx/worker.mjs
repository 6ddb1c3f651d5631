#!/usr/bin/env node
// PhysX 5 beside the exact model. ../README.md says what is set in both sets and why.

import { readFileSync } from 'node:fs';
import { angles, groundReach, kineticFriction, middle, neighbourMeans, onOff, restitution, serve, setting, threshold, turn, whole } from '../serve.mjs';

const metres = { unit: 'm' };

/** Tuned values that differ between the solvers come first. */
const settings = (iterations) => [
  setting('minPositionIters', 4, iterations, 1, 255, whole),
  setting('minVelocityIters', 1, 1, 0, 255, whole),
  setting('frictionOffsetThreshold', 0.04, 1e-3, 0, 10, metres),
  setting('frictionCorrelationDistance', 0.025, 1e-3, 0, 10, metres),
  setting('contactOffset', 0.02, 0.02, 1e-6, 10, metres),
  setting('maxBiasCoefficient', 1e32, 1e32, 0, 1e38, { unit: '1/s' }),
  setting('maxDepenetrationVelocity', 1e32, 1e32, 0, 1e38, { unit: 'm/s' }),
  onOff('eENABLE_PCM', 1, 1),
  onOff('eENABLE_FRICTION_EVERY_ITERATION', 0, 0),
  onOff('eENABLE_STABILIZATION', 0, 0),
  setting('ground', 0, 0, 0, 1, { whole: true, choices: ['plane', 'box'] }),
  setting('bounceThresholdVelocity', 2, 2, 1e-6, 1e3, { unit: 'm/s', ...threshold }),
  restitution('restitution'),
];

const facingUp = turn(-Math.PI / 2);  // the library's plane has its normal along x

/** The package's build knows browsers alone: it is to find one. */
async function load() {
  const wasmBinary = readFileSync(new URL('../node_modules/physx-js-webidl/physx-js-webidl.wasm', import.meta.url));
  const kept = Object.getOwnPropertyDescriptor(globalThis, 'process');
  Object.defineProperty(globalThis, 'process', { value: undefined, configurable: true });
  globalThis.window = globalThis;
  try {
    const px = await (await import('physx-js-webidl')).default({ wasmBinary });
    const foundation = px.CreateFoundation(px.PHYSICS_VERSION, new px.PxDefaultAllocator(), new px.PxDefaultErrorCallback());
    const physics = px.CreatePhysics(px.PHYSICS_VERSION, foundation, new px.PxTolerancesScale());
    return { px, physics, dispatcher: px.DefaultCpuDispatcherCreate(0) };
  } finally {
    Object.defineProperty(globalThis, 'process', kept);
  }
}

class Simulation {
  constructor({ px, physics, dispatcher }, question) {
    this.px = px;
    this.physics = physics;
    this.dt = question.dt;
    this.given = question.parameters;
    this.gravity = new px.PxVec3(0, 0, 0);
    this.vector = new px.PxVec3(0, 0, 0);
    this.scene = physics.createScene(this.describe(question.solver, dispatcher));
    const sliding = neighbourMeans(kineticFriction(question));
    const [ground, ...friction] = neighbourMeans(question.friction).map((sticking, k) => [sticking, sliding[k]]);
    this.addGround(ground, groundReach(question.blocks));
    if (question.wall) this.addWall(question.wall, ground);
    this.bodies = question.blocks.map((block, k) => this.addBlock(block, friction[k]));
  }

  describe(solver, dispatcher) {
    const { px, given } = this;
    const scene = new px.PxSceneDesc(this.physics.getTolerancesScale());
    scene.gravity = this.gravity;
    scene.cpuDispatcher = dispatcher;
    scene.filterShader = px.DefaultFilterShader();
    scene.solverType = solver === 'tgs' ? px.PxSolverTypeEnum.eTGS : px.PxSolverTypeEnum.ePGS;
    for (const [name, value] of Object.entries(given)) {
      const flag = px.PxSceneFlagEnum[name];
      if (name in scene) scene[name] = value;
      else if (flag !== undefined) scene.flags[value === 0 ? 'clear' : 'raise'](flag);
    }
    scene.flags.raise(px.PxSceneFlagEnum.eENABLE_ENHANCED_DETERMINISM);
    return scene;
  }

  shape(geometry, friction) {
    const { px, given } = this;
    const material = this.physics.createMaterial(...friction, given.restitution);
    material.setFrictionCombineMode(px.PxCombineModeEnum.eAVERAGE);
    const flags = new px.PxShapeFlags(px.PxShapeFlagEnum.eSIMULATION_SHAPE);
    const shape = this.physics.createShape(geometry, material, true, flags);
    shape.setContactOffset(given.contactOffset);
    shape.setSimulationFilterData(new px.PxFilterData(1, 1, 0, 0));
    return shape;
  }

  pose(x, y, [qx, qy, qz, qw]) {
    return new this.px.PxTransform(new this.px.PxVec3(x, y, 0), new this.px.PxQuat(qx, qy, qz, qw));
  }

  addGround(friction, reach) {
    const box = this.given.ground !== 0;
    const pose = box ? this.pose(0, -reach, turn(0)) : this.pose(0, 0, facingUp);
    const ground = this.physics.createRigidStatic(pose);
    const geometry = box ? new this.px.PxBoxGeometry(reach, reach, reach) : new this.px.PxPlaneGeometry();
    ground.attachShape(this.shape(geometry, friction));
    this.scene.addActor(ground);
  }

  addWall({ x, y, width, height, depth }, friction) {
    const wall = this.physics.createRigidStatic(this.pose(x, y, turn(0)));
    wall.attachShape(this.shape(new this.px.PxBoxGeometry(width / 2, height / 2, depth / 2), friction));
    this.scene.addActor(wall);
  }

  addBlock(block, friction) {
    const { px, given } = this;
    const body = this.physics.createRigidDynamic(this.pose(block.x, block.y, turn(block.angle)));
    const box = this.shape(new px.PxBoxGeometry(block.width / 2, block.height / 2, block.depth / 2), friction);
    box.setLocalPose(this.pose(...middle(block), turn(0)));
    body.attachShape(box);
    body.setMass(block.mass);
    body.setMassSpaceInertiaTensor(new px.PxVec3(block.inertia_about_x, block.inertia_about_y, block.inertia));
    body.setLinearDamping(0);
    body.setAngularDamping(0);
    body.setSleepThreshold(0);
    body.setSolverIterationCounts(given.minPositionIters, given.minVelocityIters);
    body.setMaxDepenetrationVelocity(given.maxDepenetrationVelocity);
    for (const lock of ['eLOCK_LINEAR_Z', 'eLOCK_ANGULAR_X', 'eLOCK_ANGULAR_Y'])
      body.setRigidDynamicLockFlag(px.PxRigidDynamicLockFlagEnum[lock], true);
    this.scene.addActor(body);
    body.setLinearVelocity(new px.PxVec3(block.velocity_x, block.velocity_y, 0));
    body.setAngularVelocity(new px.PxVec3(0, 0, -block.angular_velocity));
    return body;
  }

  /** Until the step is over: the library clears forces then. */
  load(k, { x, y, moment }) {
    this.vector.x = x;
    this.vector.y = y;
    this.vector.z = 0;
    this.bodies[k].addForce(this.vector);
    this.vector.x = this.vector.y = 0;
    this.vector.z = -moment;
    this.bodies[k].addTorque(this.vector);
  }

  step(pull) {
    this.gravity.x = pull.x;
    this.gravity.y = pull.y;
    this.scene.setGravity(this.gravity);
    this.scene.simulate(this.dt);
    this.scene.fetchResults(true);
  }

  state(k) {
    const body = this.bodies[k];
    const { p, q } = body.getGlobalPose();
    const [x, y, z] = [p.x, p.y, p.z];
    const { angle, tilt } = angles(q.x, q.y, q.z, q.w);
    const velocity = body.getLinearVelocity();
    const [vx, vy] = [velocity.x, velocity.y];
    return [x, y, angle, vx, vy, -body.getAngularVelocity().z, z, tilt];
  }

  end() {
    this.scene.release();
  }
}

await serve({
  name: 'physx',
  module: 'physx-js-webidl',
  note: ' of npm, PhysX 5.6.1, WebAssembly, single precision',
  licence: 'BSD-3-Clause, bindings MIT',
  capabilities: { wall: true, single_precision: true, kinetic_friction: true, center_of_mass: true },
  solvers: [{ solver: 'pgs', settings: settings(50) }, { solver: 'tgs', settings: settings(4) }],
  load,
  start: (library, question) => new Simulation(library, question),
});

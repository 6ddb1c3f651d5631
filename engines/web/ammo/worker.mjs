#!/usr/bin/env node
// Bullet as WebAssembly, ammo.js, beside the exact model, set up as ../../bullet sets up the compiled library: the same settings by
// the same names, as far as the interface has them. page.md says what it lacks, ../README.md what is set in both sets.

import { groundReach, isEccentric, middle, onOff, restitution, serve, setting, whole } from '../serve.mjs';

/** The library's own, m; its interface takes whole numbers alone. */
const ownThreshold = Math.fround(-0.04);

const settings = [
  setting('numIterations', 10, 50, 1, 1e6, whole),
  setting('erp2', 0.2, 0.2, 0, 1),
  onOff('splitImpulse', 1, 1),
  setting('splitImpulsePenetrationThreshold', ownThreshold, 0, -1e9, 1e9, { unit: 'm' }),
  restitution('restitution'),
];

const largestFriction = 10;  // the library clamps there
const neverDeactivated = 4;

/** Bodies' coefficients from that of the first of them on, of 32 bits as the library has them. */
function chain(first, friction) {
  const own = [Math.fround(first)];
  for (const wanted of friction) own.push(wanted === 0 ? 0 : Math.fround(wanted / own.at(-1)));
  return own;
}

/** How many units in the last place the search below goes: 1320 do for any coefficient of 32 bits. */
const farthest = 4096;

/**
 * A coefficient for each body, from the ground up, so that the product of neighbours is that of their interface; of any two,
 * where all interfaces are alike, within 0.03 %. The library rounds products to 32 bits: the square of the root is off by a bit
 * for half of all coefficients, the product of two numbers beside it need not be.
 * @throws where the third interface or a higher one rubs and the one below it does not.
 */
function factors(asked) {
  const friction = asked.map((wanted) => Math.fround(Math.min(wanted, largestFriction)));
  const [lowest, ...above] = friction;
  const alike = above.every((wanted) => wanted === lowest);
  if (!alike && above.some((wanted, k) => wanted > 0 && above[k - 1] === 0))
    throw new Error('ammo: friction above an interface without any cannot be given');
  const near = (factor) =>
    (alike ? chain(Math.sqrt(lowest) * factor, friction) : [Math.fround(lowest / factor), ...chain(factor, above)]);
  const isExact = (own) => friction.every((wanted, k) => Math.fround(own[k] * own[k + 1]) === wanted);
  for (let units = 0; units < farthest; ++units) {
    const own = near(1 + units * 2 ** -23);
    if (isExact(own)) return own;
  }
  return near(1);
}

class Simulation {
  constructor(ammo, question) {
    this.ammo = ammo;
    this.dt = question.dt;
    this.given = question.parameters;
    this.owned = [];
    this.makeWorld();
    const [ground, ...friction] = factors(question.friction);
    const reach = groundReach(question.blocks);
    this.ground = this.add({ width: 2 * reach, height: 2 * reach, depth: 2 * reach, x: 0, y: -reach, angle: 0, offset_x: 0, offset_y: 0, mass: 0 }, ground);
    this.bodies = question.blocks.map((block, k) => this.addBlock(block, friction[k]));
  }

  /** An object of the library's that lasts as long as this. */
  own(object) {
    this.owned.push(object);
    return object;
  }

  /** Of a vector for as long as `use` takes. */
  with(x, y, z, use) {
    const vector = new this.ammo.btVector3(x, y, z);
    const result = use(vector);
    this.ammo.destroy(vector);
    return result;
  }

  makeWorld() {
    const { ammo, given } = this;
    const configuration = this.own(new ammo.btDefaultCollisionConfiguration());
    const dispatcher = this.own(new ammo.btCollisionDispatcher(configuration));
    const broadphase = this.own(new ammo.btDbvtBroadphase());
    const solver = this.own(new ammo.btSequentialImpulseConstraintSolver());
    this.world = this.own(new ammo.btDiscreteDynamicsWorld(dispatcher, broadphase, solver, configuration));
    this.gravity = this.own(new ammo.btVector3(0, 0, 0));
    const chosen = this.world.getSolverInfo();
    chosen.set_m_numIterations(given.numIterations);
    chosen.set_m_erp2(given.erp2);
    chosen.set_m_splitImpulse(given.splitImpulse !== 0);
    const threshold = given.splitImpulsePenetrationThreshold;
    if (threshold === ownThreshold) return;
    if (!Number.isInteger(threshold))
      throw new Error(`ammo: splitImpulsePenetrationThreshold = ${threshold}: must be ${ownThreshold} or a whole number`);
    chosen.set_m_splitImpulsePenetrationThreshold(threshold);
  }

  add(block, friction) {
    const { ammo } = this;
    const box = this.own(this.with(block.width / 2, block.height / 2, block.depth / 2, (half) => new ammo.btBoxShape(half)));
    const shape = isEccentric(block) ? this.shift(box, middle(block)) : box;
    const info = this.with(block.inertia_about_x ?? 0, block.inertia_about_y ?? 0, block.inertia ?? 0,
      (inertia) => new ammo.btRigidBodyConstructionInfo(block.mass, null, shape, inertia));
    const body = this.own(new ammo.btRigidBody(info));
    const rotation = new ammo.btQuaternion(0, 0, 0, 1);
    this.with(0, 0, 1, (axis) => rotation.setRotation(axis, -block.angle));
    const place = this.with(block.x, block.y, 0, (origin) => new ammo.btTransform(rotation, origin));
    body.setCenterOfMassTransform(place);
    for (const used of [info, rotation, place]) ammo.destroy(used);
    body.setFriction(friction);
    body.setRestitution(Math.sqrt(this.given.restitution));  // the library takes the product
    this.world.addRigidBody(body);
    return body;
  }

  /** A shape whose middle is off its body's origin. */
  shift(box, [right, up]) {
    const { ammo } = this;
    const shape = this.own(new ammo.btCompoundShape(false));
    const level = new ammo.btQuaternion(0, 0, 0, 1);
    const place = this.with(right, up, 0, (origin) => new ammo.btTransform(level, origin));
    shape.addChildShape(place, box);
    for (const used of [level, place]) ammo.destroy(used);
    return shape;
  }

  addBlock(block, friction) {
    const body = this.add(block, friction);
    this.with(1, 1, 0, (free) => body.setLinearFactor(free));
    this.with(0, 0, 1, (free) => body.setAngularFactor(free));
    body.setActivationState(neverDeactivated);
    this.with(block.velocity_x, block.velocity_y, 0, (velocity) => body.setLinearVelocity(velocity));
    this.with(0, 0, -block.angular_velocity, (velocity) => body.setAngularVelocity(velocity));
    return body;
  }

  /** The package's interface has impulses alone; they come before the step. */
  load(k, { x, y, moment }) {
    this.with(this.dt * x, this.dt * y, 0, (impulse) => this.bodies[k].applyCentralImpulse(impulse));
    this.with(0, 0, -this.dt * moment, (impulse) => this.bodies[k].applyTorqueImpulse(impulse));
  }

  step(pull) {
    this.gravity.setValue(pull.x, pull.y, 0);
    this.world.setGravity(this.gravity);
    this.world.stepSimulation(this.dt, 0);
  }

  state(k) {
    const body = this.bodies[k];
    const place = body.getWorldTransform();
    const origin = place.getOrigin();
    const basis = place.getBasis();
    const [cosine, outX] = [basis.getRow(0).x(), basis.getRow(0).z()];
    const [sine, outY] = [basis.getRow(1).x(), basis.getRow(1).z()];
    const velocity = body.getLinearVelocity();
    return [origin.x(), origin.y(), Math.atan2(-sine, cosine), velocity.x(), velocity.y(), -body.getAngularVelocity().z(),
      origin.z(), Math.hypot(outX, outY)];
  }

  end() {
    for (const body of [this.ground, ...this.bodies]) this.world.removeRigidBody(body);
    for (const object of this.owned.reverse()) this.ammo.destroy(object);
  }
}

await serve({
  name: 'ammo',
  module: 'ammojs3',
  note: ' of npm, Bullet 3.26, WebAssembly, single precision',
  licence: 'Zlib',
  capabilities: { single_precision: true, center_of_mass: true, largest_friction: largestFriction },
  solvers: [{ solver: 'sequential-impulse', settings }],
  load: async () => (await import('ammojs3/dist/ammo.wasm.js')).default(),
  start: (ammo, question) => new Simulation(ammo, question),
});

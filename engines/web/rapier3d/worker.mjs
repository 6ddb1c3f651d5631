#!/usr/bin/env node
// Rapier in space beside the exact model. ../README.md says what is set in both sets and why.

import { angles, groundReach, neighbourMeans, onOff, restitution, serve, setting, turn, whole } from '../serve.mjs';

const settings = [
  setting('lengthUnit', 1, 0.05, 1e-6, 1e6, { unit: 'm' }),
  setting('numSolverIterations', 4, 20, 1, 1e4, whole),  // each is a substep
  setting('numInternalPgsIterations', 1, 1, 1, 1e4, whole),
  setting('contact_natural_frequency', 30, 30, 0, 1e9, { unit: '1/s' }),
  setting('normalizedAllowedLinearError', 0.005, 0.005, 0, 1),
  setting('normalizedPredictionDistance', 0.02, 0.02, 0, 1),
  setting('maxCcdSubsteps', 1, 1, 0, 100, whole),
  setting('contactSkin', 0, 0, 0, 1, { unit: 'm' }),
  onOff('activeHooks', 0, 1),  // contacts of a collider with hooks are found anew in each step
  restitution('restitution'),
];

class Simulation {
  constructor(rapier, question) {
    this.rapier = rapier;
    this.given = question.parameters;
    this.world = new rapier.World({ x: 0, y: 0, z: 0 });
    const chosen = this.world.integrationParameters;
    for (const [name, value] of Object.entries(this.given)) {
      if (name in chosen || name === 'contact_natural_frequency') chosen[name] = value;
    }
    chosen.dt = question.dt;
    this.hooks = { filterContactPair: () => rapier.SolverFlags.COMPUTE_IMPULSE, filterIntersectionPair: () => true };
    const own = neighbourMeans(question.friction);
    const reach = groundReach(question.blocks);
    this.add(rapier.RigidBodyDesc.fixed().setTranslation(0, -reach, 0), { width: 2 * reach, height: 2 * reach, depth: 2 * reach }, own[0]);
    this.bodies = question.blocks.map((block, k) => this.addBlock(block, own[k + 1]));
  }

  add(body, { width, height, depth }, friction, shape = (box) => box) {
    const { rapier, given } = this;
    const made = this.world.createRigidBody(body);
    const box = rapier.ColliderDesc.cuboid(width / 2, height / 2, depth / 2)
      .setFriction(friction)
      .setFrictionCombineRule(rapier.CoefficientCombineRule.Average)
      .setRestitution(given.restitution)
      .setContactSkin(given.contactSkin)
      .setActiveHooks(given.activeHooks === 0 ? rapier.ActiveHooks.NONE : rapier.ActiveHooks.FILTER_INTERSECTION_PAIRS);
    this.world.createCollider(shape(box), made);
    return made;
  }

  /** Turns out of the plane are locked. With motion out of it locked as well the library has no friction (page.md). */
  addBlock(block, friction) {
    const [x, y, z, w] = turn(block.angle);
    const body = this.rapier.RigidBodyDesc.dynamic()
      .setTranslation(block.x, block.y, 0)
      .setRotation({ x, y, z, w })
      .setLinvel(block.velocity_x, block.velocity_y, 0)
      .setAngvel({ x: 0, y: 0, z: -block.angular_velocity })
      .enabledRotations(false, false, true)
      .setCanSleep(false);
    const inertia = { x: block.inertia_about_x, y: block.inertia_about_y, z: block.inertia };
    return this.add(body, block, friction,
      (box) => box.setMassProperties(block.mass, { x: 0, y: 0, z: 0 }, inertia, { x: 0, y: 0, z: 0, w: 1 }));
  }

  step(pull) {
    this.world.gravity = { x: pull.x, y: pull.y, z: 0 };
    this.world.step(undefined, this.hooks);
  }

  state(k) {
    const body = this.bodies[k];
    const place = body.translation();
    const velocity = body.linvel();
    const rotation = body.rotation();
    const { angle, tilt } = angles(rotation.x, rotation.y, rotation.z, rotation.w);
    return [place.x, place.y, angle, velocity.x, velocity.y, -body.angvel().z, place.z, tilt];
  }

  end() {
    this.world.free();
  }
}

await serve({
  name: 'rapier3d',
  module: '@dimforge/rapier3d-compat',
  note: ' of npm, WebAssembly, single precision',
  licence: 'Apache-2.0',
  capabilities: { single_precision: true, lead: 0.5 / 4, tuned_lead: 0.5 / 20 },
  solvers: [{ solver: 'sequential-impulse', settings }],
  load: async () => {
    const rapier = (await import('@dimforge/rapier3d-compat')).default;
    await rapier.init();
    return rapier;
  },
  start: (rapier, question) => new Simulation(rapier, question),
});

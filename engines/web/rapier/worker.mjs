#!/usr/bin/env node
// Rapier in two dimensions beside the exact model. ../README.md says what is set in both sets and why.

import { groundReach, neighbourMeans, onOff, restitution, serve, setting, whole } from '../serve.mjs';

const settings = [
  setting('lengthUnit', 1, 0.05, 1e-6, 1e6, { unit: 'm' }),
  setting('numSolverIterations', 4, 20, 1, 1e4, whole),  // each is a substep
  setting('numInternalPgsIterations', 1, 1, 1, 1e4, whole),
  setting('contact_natural_frequency', 30, 30, 0, 1e9, { unit: '1/s' }),
  setting('normalizedAllowedLinearError', 0.005, 0.005, 0, 1),
  setting('normalizedPredictionDistance', 0.02, 0.02, 0, 1),
  setting('maxCcdSubsteps', 1, 1, 0, 100, whole),
  setting('contactSkin', 0, 0, 0, 1, { unit: 'm' }),
  onOff('activeHooks', 0, 0),  // contacts of a collider with hooks are found anew in each step
  restitution('restitution'),
];

class Simulation {
  constructor(rapier, question) {
    this.rapier = rapier;
    this.given = question.parameters;
    this.world = new rapier.World({ x: 0, y: 0 });
    this.hooks = { filterContactPair: () => rapier.SolverFlags.COMPUTE_IMPULSE, filterIntersectionPair: () => true };
    const chosen = this.world.integrationParameters;
    for (const [name, value] of Object.entries(this.given)) {
      if (name in chosen || name === 'contact_natural_frequency') chosen[name] = value;
    }
    chosen.dt = question.dt;
    const own = neighbourMeans(question.friction);
    const reach = groundReach(question.blocks);
    this.ground = this.add(rapier.RigidBodyDesc.fixed().setTranslation(0, -reach), reach, reach, own[0]);
    this.bodies = question.blocks.map((block, k) => this.addBlock(block, own[k + 1]));
  }

  /** A box of these half sizes. */
  add(body, width, height, friction, shape = (box) => box) {
    const made = this.world.createRigidBody(body);
    const box = this.rapier.ColliderDesc.cuboid(width, height)
      .setFriction(friction)
      .setFrictionCombineRule(this.rapier.CoefficientCombineRule.Average)
      .setRestitution(this.given.restitution)
      .setContactSkin(this.given.contactSkin)
      .setActiveHooks(this.given.activeHooks === 0 ? this.rapier.ActiveHooks.NONE : this.rapier.ActiveHooks.FILTER_INTERSECTION_PAIRS);
    this.world.createCollider(shape(box), made);
    return made;
  }

  addBlock(block, friction) {
    const body = this.rapier.RigidBodyDesc.dynamic()
      .setTranslation(block.x, block.y)
      .setRotation(-block.angle)
      .setLinvel(block.velocity_x, block.velocity_y)
      .setAngvel(-block.angular_velocity)
      .setCanSleep(false);
    return this.add(body, block.width / 2, block.height / 2, friction,
      (box) => box.setMassProperties(block.mass, { x: 0, y: 0 }, block.inertia));
  }

  step(pull) {
    this.world.gravity = pull;
    this.world.step(undefined, this.hooks);
  }

  state(k) {
    const body = this.bodies[k];
    const place = body.translation();
    const velocity = body.linvel();
    return [place.x, place.y, -body.rotation(), velocity.x, velocity.y, -body.angvel()];
  }

  /** Impulses are those of all substeps. */
  contacts() {
    const points = [];
    this.bodies.forEach((upper, k) => {
      const [above, below] = [upper, k > 0 ? this.bodies[k - 1] : this.ground].map((body) => body.collider(0));
      this.world.contactPair(below, above, (manifold, flipped) => {
        const [{ x, y }, turned, side] = [manifold.normal(), upper.rotation(), flipped ? -1 : 1];
        for (let i = 0; i < manifold.numContacts(); ++i) {
          const [push, rub] = [manifold.contactImpulse(i), manifold.contactTangentImpulse(i)];
          const on = flipped ? manifold.localContactPoint1(i) : manifold.localContactPoint2(i);
          points.push({ interface: k, along: on.x, push, x: side * (push * x - rub * y), y: side * (push * y + rub * x) });
        }
      });
    });
    return points;
  }

  end() {
    this.world.free();
  }
}

await serve({
  name: 'rapier',
  module: '@dimforge/rapier2d-deterministic-compat',
  note: ' of npm, WebAssembly, single precision',
  licence: 'Apache-2.0',
  capabilities: { single_precision: true, planar: true, lead: 0.5 / 4, tuned_lead: 0.5 / 20 },
  solvers: [{ solver: 'sequential-impulse', settings }],
  load: async () => {
    const rapier = (await import('@dimforge/rapier2d-deterministic-compat')).default;
    await rapier.init();
    return rapier;
  },
  start: (rapier, question) => new Simulation(rapier, question),
});

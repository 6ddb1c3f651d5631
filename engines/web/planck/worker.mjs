#!/usr/bin/env node
// Planck, a port of Box2D 2 to JavaScript, beside the exact model. ../README.md says what is set in both sets and why.

import { groundReach, middle, onOff, restitution, serve, setting, threshold, whole } from '../serve.mjs';

const settings = [
  setting('velocityIterations', 8, 50, 1, 1e6, whole),
  setting('positionIterations', 3, 3, 0, 1e6, whole),
  onOff('warmStarting', 1, 1),
  onOff('continuousPhysics', 1, 0),
  setting('polygonRadius', 0.01, 0, 0, 1e3, { unit: 'm' }),
  restitution('restitution'),
  setting('velocityThreshold', 1, 1, 0, 1e9, threshold),
  setting('lengthUnit', 1, 0.02, 1e-6, 1e6, { unit: 'm' }),
];

class Simulation {
  constructor(planck, question) {
    this.planck = planck;
    this.dt = question.dt;
    this.given = question.parameters;
    planck.Settings.lengthUnitsPerMeter = this.given.lengthUnit;
    planck.Settings.velocityThreshold = this.given.velocityThreshold;
    this.world = new planck.World({
      allowSleep: false,
      warmStarting: this.given.warmStarting !== 0,
      continuousPhysics: this.given.continuousPhysics !== 0,
    });
    this.bodies = [];
    this.touches = new Map();
    const reach = groundReach(question.blocks);
    this.add({ type: 'static', position: { x: 0, y: -reach } }, reach, reach);
    if (question.wall) this.addWall(question.wall);
    for (const block of question.blocks) this.addBlock(block);
    // The library would take the root of a product.
    this.world.on('pre-solve', (contact) => {
      const [one, other] = [contact.getFixtureA(), contact.getFixtureB()].map((fixture) => fixture.getUserData());
      contact.setFriction(question.friction[Math.max(one, other) - 1]);
      if (question.reactions) this.find(contact, one, other);
    });
    if (question.reactions) this.world.on('post-solve', (contact, impulse) => this.push(contact, impulse));
  }

  /** Contact points where the step starts, with the normal out of the lower body. */
  find(contact, one, other) {
    if (this.touches.has(contact)) return;
    const { normal, points, pointCount } = contact.getWorldManifold(null);
    const side = other > one ? 1 : -1;
    const k = Math.max(one, other) - 1;
    this.touches.set(contact, points.slice(0, pointCount).map((point) => ({
      interface: k, along: this.bodies[k + 1].getLocalPoint(point).x, push: 0, x: 0, y: 0, normal: { x: side * normal.x, y: side * normal.y },
    })));
  }

  push(contact, { normalImpulses, tangentImpulses }) {
    this.touches.get(contact)?.forEach((point, i) => {
      const { x, y } = point.normal;
      point.push += normalImpulses[i];
      point.x += normalImpulses[i] * x + tangentImpulses[i] * y;
      point.y += normalImpulses[i] * y - tangentImpulses[i] * x;
    });
  }

  contacts() { return [...this.touches.values()].flat(); }

  /** A box of these half sizes and this middle; bodies are numbered from 0, the ground. */
  add(definition, width, height, [x, y] = [0, 0]) {
    const box = new this.planck.Box(width, height, { x, y });
    box.m_radius = this.given.polygonRadius;
    const body = this.world.createBody(definition);
    body.createFixture({ shape: box, restitution: this.given.restitution, userData: this.bodies.length });
    this.bodies.push(body);
    return body;
  }

  /** Of the ground's body, whose number it has. */
  addWall({ x, y, width, height }) {
    const [ground] = this.bodies;
    const box = new this.planck.Box(width / 2, height / 2, { x: x - ground.getPosition().x, y: y - ground.getPosition().y });
    box.m_radius = this.given.polygonRadius;
    ground.createFixture({ shape: box, restitution: this.given.restitution, userData: 0 });
  }

  addBlock(block) {
    const body = this.add({
      type: 'dynamic',
      position: { x: block.x, y: block.y },
      angle: -block.angle,
      linearVelocity: { x: block.velocity_x, y: block.velocity_y },
      angularVelocity: -block.angular_velocity,
    }, block.width / 2, block.height / 2, middle(block));
    body.setMassData({ mass: block.mass, center: { x: 0, y: 0 }, I: block.inertia });
  }

  /** Until the step is over: the library clears forces then. */
  load(k, { x, y, moment }) {
    const body = this.bodies[k + 1];
    body.applyForceToCenter({ x, y }, true);
    body.applyTorque(-moment, true);
  }

  step(pull) {
    this.touches.clear();
    this.world.setGravity(pull);
    this.world.step(this.dt, this.given.velocityIterations, this.given.positionIterations);
  }

  state(k) {
    const body = this.bodies[k + 1];
    const place = body.getPosition();
    const velocity = body.getLinearVelocity();
    return [place.x, place.y, -body.getAngle(), velocity.x, velocity.y, -body.getAngularVelocity()];
  }
}

await serve({
  name: 'planck',
  module: 'planck',
  note: ' of npm, JavaScript, double precision',
  licence: 'MIT',
  capabilities: { wall: true, planar: true, center_of_mass: true },
  solvers: [{ solver: 'sequential-impulse', settings }],
  load: () => import('planck'),
  start: (planck, question) => new Simulation(planck, question),
});

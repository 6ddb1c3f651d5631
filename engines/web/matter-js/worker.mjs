#!/usr/bin/env node
// Matter.js beside the exact model. ../README.md says what is set in both sets and why.

import { groundReach, massFactor, middle, restitution, serve, setting, whole } from '../serve.mjs';

const settings = [
  setting('lengthUnit', 0.01, 0.01, 1e-6, 1e6, { unit: 'm' }),
  setting('unitMass', 0, 0, 0, 1e12, { unit: 'kg' }),
  setting('inertiaScale', 4, 3, 1e-6, 1e6),
  setting('positionIterations', 6, 7, 0, 1e6, whole),
  setting('velocityIterations', 4, 50, 1, 1e6, whole),
  setting('slop', 0.05, 0.05, 0, 1e3),
  setting('frictionStatic', 0.5, 0.5, 0, 1e12),
  restitution('restitution'),
];

class Simulation {
  constructor(matter, question) {
    this.matter = matter;
    this.given = question.parameters;
    this.scale = 1 / this.given.lengthUnit;
    this.dt = question.dt;
    this.engine = matter.Engine.create({
      positionIterations: this.given.positionIterations, velocityIterations: this.given.velocityIterations,
    });
    // Pixels for each square of a millisecond.
    this.engine.gravity.scale = 1e-6 * this.scale;
    this.friction = question.friction;
    const reach = groundReach(question.blocks);
    this.bodies = [];
    this.add({ x: 0, y: -reach, width: 2 * reach, height: 2 * reach }, { isStatic: true });
    if (question.wall) this.addWall(question.wall);
    this.masses = massFactor(question);
    for (const block of question.blocks) this.addBlock(block);
  }

  /** Bodies are numbered from 0, the ground. */
  add({ x, y, width, height }, more) {
    const [left, up, wide, high] = [x, y, width, height].map((length) => length * this.scale);
    const { restitution: bounce, slop, frictionStatic } = this.given;
    const plugin = { friction: this.friction[this.bodies.length - 1] };
    const body = this.matter.Bodies.rectangle(left, up, wide, high, {
      frictionAir: 0, restitution: bounce, slop, frictionStatic, plugin, deltaTime: 1000 * this.dt, ...more,
    });
    this.matter.Composite.add(this.engine.world, body);
    this.bodies.push(body);
    return body;
  }

  /** Still, as the ground is; a block above has the friction of its own interface. */
  addWall(wall) {
    this.add(wall, { isStatic: true });
    this.bodies.pop();
  }

  addBlock(block) {
    const { masses } = this;
    const body = this.add(block, {
      angle: -block.angle,
      mass: masses * block.mass,
      inertia: masses * block.inertia * this.given.inertiaScale * this.scale ** 2,
    });
    // A body turns about its place, which the library has put into the middle of its corners.
    const [right, up] = middle(block).map((length) => length * this.scale);
    const [cosine, sine] = [Math.cos(block.angle), Math.sin(block.angle)];
    this.matter.Vertices.translate(body.vertices, { x: right * cosine + up * sine, y: up * cosine - right * sine });
    // Its velocities are those of a sixtieth of a second.
    const base = 1 / 60;
    this.matter.Body.setVelocity(body, { x: block.velocity_x * this.scale * base, y: block.velocity_y * this.scale * base });
    this.matter.Body.setAngularVelocity(body, -block.angular_velocity * base);
  }

  /** The library's time is in ms, its force clears with the step. */
  load(k, { x, y, moment }) {
    const body = this.bodies[k + 1];
    const factor = 1e-6 * this.masses * this.scale;
    body.force = { x: factor * x, y: factor * y };
    body.torque = -factor * this.scale * this.given.inertiaScale * moment;
  }

  step(pull) {
    Object.assign(this.engine.gravity, pull);
    this.matter.Engine.update(this.engine, 1000 * this.dt);
  }

  state(k) {
    const { position, positionPrev, angle, anglePrev } = this.bodies[k + 1];
    const lengths = [position.x, position.y].map((length) => length * this.given.lengthUnit);
    const speeds = [position.x - positionPrev.x, position.y - positionPrev.y].map((way) => way * this.given.lengthUnit / this.dt);
    return [...lengths, -angle, ...speeds, -(angle - anglePrev) / this.dt];
  }
}

await serve({
  name: 'matter-js',
  module: 'matter-js',
  note: ' of npm, JavaScript, double precision',
  licence: 'MIT',
  capabilities: { wall: true, planar: true, center_of_mass: true },
  solvers: [{ solver: 'sequential-impulse', settings }],
  load: async () => {
    const { default: matter } = await import('matter-js');
    // The library would take the least of two bodies; of neighbours, the upper one knows their interface.
    matter.after('Pair.update', (pair) => {
      const upper = pair.bodyA.id > pair.bodyB.id ? pair.bodyA : pair.bodyB;
      pair.friction = upper.plugin.friction;
    });
    return matter;
  },
  start: (matter, question) => new Simulation(matter, question),
});

#!/usr/bin/env node
// Rapier in two dimensions beside the exact model. ../README.md says what is set in both sets and why.

import { middle } from '../serve.mjs';
import { RapierStack, serveRapier } from './stack.mjs';

class Stack extends RapierStack {
  vector(x, y) {
    return { x, y };
  }

  torque(moment) {
    return moment;
  }

  cuboid({ width, height }) {
    return this.rapier.ColliderDesc.cuboid(width / 2, height / 2);
  }

  turned(body, block) {
    return body.setRotation(-block.angle).setAngvel(-block.angular_velocity);
  }

  weighed(box, block) {
    return box.setTranslation(...middle(block)).setMassProperties(block.mass, this.vector(block.offset_x, block.offset_y), block.inertia);
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
        const [{ x, y }, side] = [manifold.normal(), flipped ? -1 : 1];
        for (let i = 0; i < manifold.numContacts(); ++i) {
          const [push, rub] = [manifold.contactImpulse(i), manifold.contactTangentImpulse(i)];
          const on = flipped ? manifold.localContactPoint1(i) : manifold.localContactPoint2(i);
          points.push({ interface: k, along: on.x + this.middles[k][0], push, x: side * (push * x - rub * y), y: side * (push * y + rub * x) });
        }
      });
    });
    return points;
  }
}

await serveRapier({
  name: 'rapier',
  module: '@dimforge/rapier2d-deterministic-compat',
  capabilities: { planar: true },
  tunedIterations: 100,
  Stack,
});

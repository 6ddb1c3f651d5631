#!/usr/bin/env node
// Rapier in space beside the exact model. ../README.md says what is set in both sets and why.

import { RapierStack, serveRapier } from '../rapier/stack.mjs';
import { angles, middle, turn } from '../serve.mjs';

class Stack extends RapierStack {
  vector(x, y) {
    return { x, y, z: 0 };
  }

  torque(moment) {
    return { x: 0, y: 0, z: moment };
  }

  cuboid({ width, height, depth }) {
    return this.rapier.ColliderDesc.cuboid(width / 2, height / 2, depth / 2);
  }

  /** Turns out of the plane are locked. With motion out of it locked as well the library has no friction (page.md). */
  turned(body, block) {
    const [x, y, z, w] = turn(block.angle);
    return body.setRotation({ x, y, z, w }).setAngvel({ x: 0, y: 0, z: -block.angular_velocity }).enabledRotations(false, false, true);
  }

  weighed(box, block) {
    const inertia = { x: block.inertia_about_x, y: block.inertia_about_y, z: block.inertia };
    return box.setTranslation(...middle(block), 0)
      .setMassProperties(block.mass, this.vector(block.offset_x, block.offset_y), inertia, { x: 0, y: 0, z: 0, w: 1 });
  }

  state(k) {
    const body = this.bodies[k];
    const place = body.translation();
    const velocity = body.linvel();
    const rotation = body.rotation();
    const { angle, tilt } = angles(rotation.x, rotation.y, rotation.z, rotation.w);
    return [place.x, place.y, angle, velocity.x, velocity.y, -body.angvel().z, place.z, tilt];
  }
}

await serveRapier({ name: 'rapier3d', module: '@dimforge/rapier3d-compat', tunedIterations: 20, Stack });

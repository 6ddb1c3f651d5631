// A stack in Rapier, whatever its dimensions: ./worker.mjs has two, ../rapier3d/worker.mjs three.

import { groundReach, middle, neighbourMeans, onOff, restitution, serve, setting, whole } from '../serve.mjs';

const settings = (tunedIterations) => [
  setting('lengthUnit', 1, 0.05, 1e-6, 1e6, { unit: 'm' }),
  setting('numSolverIterations', 4, tunedIterations, 1, 1e4, whole),  // each is a substep
  setting('numInternalPgsIterations', 1, 1, 1, 1e4, whole),
  setting('contact_natural_frequency', 30, 30, 0, 1e9, { unit: '1/s' }),
  setting('normalizedAllowedLinearError', 0.005, 0.005, 0, 1),
  setting('normalizedPredictionDistance', 0.02, 0.02, 0, 1),
  setting('maxCcdSubsteps', 1, 1, 0, 100, whole),
  setting('contactSkin', 0, 0, 0, 1, { unit: 'm' }),
  onOff('activeHooks', 0, 1),  // contacts of a collider with hooks are found anew in each step
  restitution('restitution'),
];

/**
 * Those derived from it know their dimensions: `vector(x, y)`; `torque(moment)`, about the axis out of the plane; `cuboid(block)`, a box of its size; `turned(body, block)`, a body as it
 * starts to turn; `weighed(box, block)`, a box with its place in the body, its mass and inertia; and `state(k)`.
 */
export class RapierStack {
  constructor(rapier, question) {
    this.rapier = rapier;
    this.given = question.parameters;
    this.world = new rapier.World(this.vector(0, 0));
    this.hooks = { filterContactPair: () => rapier.SolverFlags.COMPUTE_IMPULSE, filterIntersectionPair: () => true };
    const chosen = this.world.integrationParameters;
    for (const [name, value] of Object.entries(this.given)) {
      if (name in chosen || name === 'contact_natural_frequency') chosen[name] = value;
    }
    chosen.dt = question.dt;
    const own = neighbourMeans(question.friction);
    const reach = groundReach(question.blocks);
    const ground = this.cuboid({ width: 2 * reach, height: 2 * reach, depth: 2 * reach });
    this.ground = this.add(rapier.RigidBodyDesc.fixed().setTranslation(...this.numbers(0, -reach)), ground, own[0]);
    if (question.wall) this.addWall(question.wall, own[0]);
    this.bodies = question.blocks.map((block, k) => this.addBlock(block, own[k + 1]));
    this.middles = question.blocks.map(middle);
  }

  numbers(x, y) {
    return Object.values(this.vector(x, y));
  }

  add(body, box, friction) {
    const { rapier, given } = this;
    const made = this.world.createRigidBody(body);
    box.setFriction(friction)
      .setFrictionCombineRule(rapier.CoefficientCombineRule.Average)
      .setRestitution(given.restitution)
      .setContactSkin(given.contactSkin)
      .setActiveHooks(given.activeHooks === 0 ? rapier.ActiveHooks.NONE : rapier.ActiveHooks.FILTER_INTERSECTION_PAIRS);
    this.world.createCollider(box, made);
    return made;
  }

  addWall(wall, friction) {
    this.add(this.rapier.RigidBodyDesc.fixed().setTranslation(...this.numbers(wall.x, wall.y)), this.cuboid(wall), friction);
  }

  addBlock(block, friction) {
    const body = this.rapier.RigidBodyDesc.dynamic()
      .setTranslation(...this.numbers(block.x, block.y))
      .setLinvel(...this.numbers(block.velocity_x, block.velocity_y))
      .setCanSleep(false);
    return this.add(this.turned(body, block), this.weighed(this.cuboid(block), block), friction);
  }

  /** The library keeps forces until they are reset. */
  load(k, { x, y, moment }) {
    const body = this.bodies[k];
    body.resetForces(true);
    body.resetTorques(true);
    body.addForce(this.vector(x, y), true);
    body.addTorque(this.torque(-moment), true);
  }

  step(pull) {
    this.world.gravity = this.vector(pull.x, pull.y);
    this.world.step(undefined, this.hooks);
  }

  end() {
    this.world.free();
  }
}

/** Answers for an engine as serve() has it, which suits rocking blocks with `tunedIterations`; `Stack` is its class. */
export async function serveRapier({ name, module, capabilities, tunedIterations, Stack }) {
  await serve({
    name,
    module,
    note: ' of npm, WebAssembly, single precision',
    licence: 'Apache-2.0',
    capabilities: { wall: true, single_precision: true, center_of_mass: true, lead: 0.5 / 4, tuned_lead: 0.5 / tunedIterations, ...capabilities },
    solvers: [{ solver: 'sequential-impulse', settings: settings(tunedIterations) }],
    load: async () => {
      const rapier = (await import(module)).default;
      await rapier.init();
      return rapier;
    },
    start: (rapier, question) => new Stack(rapier, question),
  });
}

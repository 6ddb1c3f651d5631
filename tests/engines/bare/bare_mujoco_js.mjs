#!/usr/bin/env node
// A stack of blocks in MuJoCo 3 by its own calls alone. What is not set stays as the library has it, but for the cone.
// `convex 1` has the library's two newer ways to let convex shapes touch the other way round.

import { inPackage, printAngles, readQuestion } from './question.mjs';

const { default: load } = await import(inPackage('mujoco-js/dist/mujoco_wasm.js'));
const mujoco = await load();
const question = readQuestion();
const { set, friction, reach } = question;
const of = (name, standard) => set[name] ?? standard;
const solref = `${of('solref_timeconst', 0.02)} ${of('solref_dampratio', 1)}`;
const solimp = `${of('solimp_d0', 0.9)} ${of('solimp_dwidth', 0.95)} 0.001 0.5 2`;
const still = 'contype="0" conaffinity="0"';
const bodies = question.blocks.map(({ width, height, depth, mass, aboutZ }, k) => `
  <body><joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint type="hinge" axis="0 0 1"/>
    <inertial pos="0 0 0" mass="${mass}" diaginertia="${aboutZ} ${aboutZ} ${aboutZ}"/>
    <geom name="b${k}" type="box" ${still} size="${width / 2} ${height / 2} ${of('depth_ratio', 1) ** k * depth / 2}"/></body>`);
const names = ['ground', ...question.blocks.map((_, k) => `b${k}`)];
const pairs = names.flatMap((upper, k) => names.slice(0, k).map((lower) => `
  <pair geom1="${lower}" geom2="${upper}" condim="3" friction="${friction} ${friction} 0 0 0" solref="${solref}" solimp="${solimp}"/>`));
mujoco.FS.writeFile('stack.xml', `<mujoco>
  <option timestep="${question.dt}" solver="${{ newton: 'Newton', cg: 'CG', pgs: 'PGS' }[question.solver]}" cone="elliptic"
    iterations="${of('iterations', 100)}" tolerance="${of('tolerance', 1e-8)}">
    <flag ${question.convex ? 'multiccd="enable" nativeccd="disable"' : ''}/></option>
  <worldbody><geom name="ground" type="plane" ${still} size="${reach} ${reach} 1" zaxis="0 1 0"/>${bodies.join('')}</worldbody>
  <contact>${pairs.join('')}</contact></mujoco>`);
const model = mujoco.MjModel.loadFromXML('stack.xml');
const data = new mujoco.MjData(model);
data.qpos.set(question.blocks.flatMap(({ x, y, angle }) => [x, y, -angle]));
printAngles(question, (x, y) => {
  model.opt.gravity.set([x, y, 0]);
  mujoco.mj_step(model, data);
}, (k) => -data.qpos[3 * k + 2]);

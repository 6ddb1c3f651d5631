// What bare programs of npm's libraries share: the words on standard input, and where the libraries are. Nothing of the
// adapters is read here. The words are those of bare_box2d.cpp, and one more, which Havok, Jolt and Rapier hear:
//
//   moving 0.5 -1 0.1   (of the block before it: velocity right and up, m/s, and clockwise, rad/s)

import { readFileSync } from 'node:fs';

const fields = ['width', 'height', 'depth', 'mass', 'aboutX', 'aboutY', 'aboutZ', 'x', 'y', 'angle'];

export function readQuestion() {
  const words = readFileSync(0, 'utf8').split(/\s+/).filter((word) => word);
  const question = { blocks: [], set: {}, shaking: [] };
  const number = () => Number(words.shift());
  while (words.length > 0) {
    const word = words.shift();
    if (word === 'solver') question.solver = words.shift();
    else if (word === 'block') question.blocks.push(Object.fromEntries(fields.map((field) => [field, number()])));
    else if (word === 'moving') Object.assign(question.blocks.at(-1), { right: number(), up: number(), spin: number() });
    else if (word === 'set') question.set[words.shift()] = number();
    else if (word === 'shake') question.shaking.push([number(), number()]);
    else question[word] = number();
  }
  return question;
}

/** Prints the angles at the start and after each step: `step` takes one under gravity (x, y), `angle` tells block k's. */
export function printAngles(question, step, angle) {
  const line = () => question.blocks.map((_, k) => angle(k)).join(' ');
  const lines = [line()];
  for (let n = 0; n < question.steps; ++n) {
    const [x, y] = question.shaking[n] ?? [0, 0];
    step(-x, -question.gravity - y);
    lines.push(line());
  }
  console.log(lines.join('\n'));
}

/** A file of a package. */
export function inPackage(path) {
  return new URL(`../../../engines/web/node_modules/${path}`, import.meta.url);
}

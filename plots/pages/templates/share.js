"use strict";
// What readers have made of a scene: a link to it on this page, and a file that the program reads.
const share = (() => {
const mark = "#scene=";

// A value of a scene file. A page has what is infinite as a word.
const fileText = (value) => {
  if (Array.isArray(value)) return `[${value.map(fileText).join(", ")}]`;
  if (value === "inf") return value;
  if (typeof value !== "object") return JSON.stringify(value);
  return `{ ${Object.entries(value).map(([key, one]) => `${key} = ${fileText(one)}`).join(", ")} }`;
};

const fileOf = (scene) => Object.entries(scene).map(([key, value]) => `${key} = ${fileText(value)}\n`).join("");

// [the name of the player, its scene] of the link that led here; nothing where it is another one, or cut short.
const linked = (() => {
  try {
    return location.hash.startsWith(mark) ? JSON.parse(decodeURIComponent(location.hash.slice(mark.length))) : [];
  } catch {
    return [];
  }
})();

const download = (name, text) => {
  const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(new Blob([text], { type: "text/plain" })), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
};

// Buttons of a trial; what its link holds is solved at once.
const buttons = (trial) => {
  const { player } = trial, name = player.find("stage").id;
  const button = (textContent, act) => {
    const one = Object.assign(document.createElement("button"), { type: "button", textContent });
    one.addEventListener("click", act);
    return one;
  };
  if (linked[0] === name) trial.change(() => { trial.scene = linked[1]; });
  return [
    button("Copy link", async () => {
      history.replaceState(null, "", mark + encodeURIComponent(JSON.stringify([name, trial.scene])));
      await navigator.clipboard?.writeText(location.href).catch(() => {});
      player.say("The link in the address bar holds this scene.");
    }),
    button("Save as scene", () => {
      download("scene.toml", fileOf(trial.scene));
      player.say("Saved as scene.toml. Where it lies: rockstack solve scene.toml");
    })];
};

return { buttons, fileOf };
})();

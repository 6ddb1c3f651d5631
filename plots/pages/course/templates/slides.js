"use strict";
// Makes slides of a lesson's text. A heading, or what is marked data-title, is the title of what follows it. A prediction and a question have two slides,
// without the answer and with it; a player, a figure, sliders and a marked table have their own. Formulas and what is marked data-slide share one; of a
// paragraph or an item with marked phrases, these alone. data-slide="…" gives a title as well. Large type: what does not fit is made smaller until it does.
(() => {
const made = (tag, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};

const slide = (heading, ...children) => made("section", { className: "slide" }, made("h2", { innerHTML: heading }), ...children);

// A question, and then the same with its answer.
const asked = (heading, question, answer) => {
  const box = made("div", { className: "answer-part" }, ...answer);
  const copies = question.map((part) => part.cloneNode(true));
  return [slide(heading, ...question), slide(heading, ...copies, box)];
};

const prediction = (form) => {
  const question = Array.from(form.querySelectorAll(".given, .ask"), (text) => made("p", { className: text.className, innerHTML: text.innerHTML }));
  const choices = Array.from(form.querySelectorAll("label.choice"), (label) => made("li", { textContent: label.textContent }));
  if (choices.length) question.push(made("ol", { type: "A" }, ...choices));
  return asked("Predict", question, Array.from(form.querySelectorAll(".revealed p:not(.verdict)")));
};

const question = (one) =>
  asked("Question", [made("p", { innerHTML: one.querySelector("summary").innerHTML })], Array.from(one.querySelectorAll("p")));

// Slides of a long table: as many as it takes, that each can be read, with as many rows each.
const tables = (heading, table) => {
  const most = 8, rows = Array.from(table.tBodies[0].rows), list = [], count = Math.ceil(rows.length / Math.ceil(rows.length / most));
  for (let from = 0; from < rows.length; from += count) {
    const part = table.cloneNode(true);
    part.tBodies[0].replaceChildren(...rows.slice(from, from + count));
    list.push(slide(heading, part));
  }
  return list;
};

// Leaves of a paragraph or an item in which phrases are marked these alone.
const shorten = (part) => {
  for (const one of [part, ...part.querySelectorAll("li")]) {
    const phrases = one.querySelectorAll(":scope > [data-slide]");
    if (phrases.length) one.replaceChildren(...Array.from(phrases).flatMap((phrase) => [phrase, " "]));
  }
};

const titles = "h2, [data-title]", alone = ".player, figure, .try, table";
const parts = `${titles}, [data-slide], math[display], .player, figure, .try, .predict, .question`;

const slidesOf = (text) => {
  const list = [];
  let title = "", open = null;
  for (const part of Array.from(text.querySelectorAll(parts)).filter((one) => !one.parentElement.closest(parts))) {
    const named = part.matches(titles) ? part : part.querySelector("[data-title]");
    const words = part.dataset.slide || named?.innerHTML.replace(/[.:]$/, ""), whole = [part, ...part.children].find((one) => one.matches(alone));
    if (words) [title, open] = [words, null];
    if (part === named) continue;
    if (part.matches(".predict")) list.push(...prediction(part));
    else if (part.matches(".question")) list.push(...question(part));
    else if (whole) list.push(...whole.matches("table") ? tables(title, whole) : [slide(title, whole)]);
    else {
      shorten(part);
      if (!open) list.push(open = slide(title));
      open.append(part);
      continue;
    }
    open = null;
  }
  return list;
};

const text = document.getElementById("text");
text.replaceWith(...slidesOf(text));

// On a screen that is higher than wide, as a phone's, a slide is scrolled rather than small.
const fit = (one) => {
  const least = innerHeight > innerWidth ? 0.8 : 0.4;
  for (let scale = 1; scale >= least; scale -= 0.05) {
    one.style.setProperty("--fit", scale);
    if (one.scrollHeight <= one.clientHeight + 1 && one.scrollWidth <= one.clientWidth + 1) break;
  }
  for (const { player } of one.querySelectorAll(".player")) player?.resize();
};

// Where the page cannot solve, sliders have no slide.
let slides, place = 0;
const begin = () => {
  for (const one of document.querySelectorAll(".slide:has(.try[hidden])")) one.remove();
  slides = Array.from(document.querySelectorAll(".slide"));
  for (const one of slides) one.setAttribute("aria-label", one.querySelector("h1, h2").textContent);
  window.slideShow = { slides, show };
  show(Number(location.hash.slice(1)) - 1 || 0);
};

const show = (next) => {
  slides[place].classList.remove("now");
  place = Math.max(0, Math.min(slides.length - 1, next));
  slides[place].classList.add("now");
  document.getElementById("place").textContent = `${place + 1} of ${slides.length}`;
  document.getElementById("back").disabled = place === 0;
  document.getElementById("next").disabled = place === slides.length - 1;
  history.replaceState(null, "", `#${place + 1}`);
};

const keys = { ArrowRight: 1, PageDown: 1, ArrowLeft: -1, PageUp: -1, Home: -Infinity, End: Infinity };
addEventListener("keydown", (event) => {
  const way = keys[event.key];
  if (way === undefined || event.target.closest(".player, input, select")) return;
  event.preventDefault();
  show(place + way);
});
document.getElementById("back").addEventListener("click", () => show(place - 1));
document.getElementById("next").addEventListener("click", () => show(place + 1));
// All of them, as paper shows them all.
const fitAll = () => {
  for (const one of slides) {
    one.classList.add("now");
    fit(one);
    one.classList.toggle("now", one === slides[place]);
  }
};
document.addEventListener("DOMContentLoaded", begin);
addEventListener("resize", fitAll);
addEventListener("load", fitAll);
})();

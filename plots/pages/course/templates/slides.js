"use strict";
// Makes slides of a lesson's text: of each section its key sentences and formulas, then its figures, tables, player and
// questions one by one. Large type: what does not fit is made smaller until it does.
(() => {
const made = (tag, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};

const slide = (heading, ...children) => {
  const one = made("section", { className: "slide" }, made("h2", { innerHTML: heading }), ...children);
  one.setAttribute("aria-label", one.firstChild.textContent);
  return one;
};

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

// A key sentence as a point of its own: it begins as one, and ends where the text goes on to what it tells of.
const pointOf = (sentence) => {
  const point = made("li", { innerHTML: sentence.innerHTML.trim().replace(/[:;]$/, ".") });
  const first = document.createTreeWalker(point, NodeFilter.SHOW_TEXT).nextNode();
  first.data = first.data.charAt(0).toUpperCase() + first.data.slice(1);
  return point;
};

// Of a long table as many as it takes, that each can be read.
const tables = (table) => {
  const most = 8, rows = Array.from(table.tBodies[0].rows), list = [];
  for (let from = 0; from < rows.length; from += most) {
    list.push(table.cloneNode(true));
    list.at(-1).tBodies[0].replaceChildren(...rows.slice(from, from + most));
  }
  return list;
};

const whole = "figure, .player, section > table, pre, .predict, .question";

const slidesOf = (section) => {
  const heading = section.querySelector("h2").innerHTML, list = [];
  const points = made("ul"), first = [points];
  for (const part of section.querySelectorAll(`.key, math[display="block"], ${whole}`)) {
    if (part.closest(".player, .predict, .question") && !part.matches(whole)) continue;
    if (part.matches(".key")) points.append(pointOf(part));
    else if (part.matches("math")) first.push(part);
    else if (part.matches(".predict")) list.push(...prediction(part));
    else if (part.matches(".question")) {
      const question = [made("p", { innerHTML: part.querySelector("summary").innerHTML })];
      list.push(...asked(heading, question, Array.from(part.querySelectorAll("p"))));
    } else if (part.matches("table")) list.push(...tables(part).map((table) => slide(heading, table)));
    else list.push(slide(heading, part));
  }
  // A prediction comes before what tells its answer.
  const told = slide(heading, ...first);
  const has = points.children.length || first.length > 1;
  const before = list.findIndex((one) => one.getAttribute("aria-label") !== "Predict");
  if (has) list.splice(before < 0 ? list.length : before, 0, told);
  return list;
};

const text = document.getElementById("text");
const ready = Array.from(text.children).filter((one) => one.matches("section")).flatMap(slidesOf);
text.replaceWith(...ready);

const slides = Array.from(document.querySelectorAll(".slide"));
const least = 0.4;
const fit = (one) => {
  for (let scale = 1; scale >= least; scale -= 0.05) {
    one.style.setProperty("--fit", scale);
    if (one.scrollHeight <= one.clientHeight + 1 && one.scrollWidth <= one.clientWidth + 1) break;
  }
  one.querySelector(".player")?.player?.resize();
};

let place = 0;
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
addEventListener("resize", fitAll);
addEventListener("load", fitAll);
window.slideShow = { slides, show };
show(Number(location.hash.slice(1)) - 1 || 0);
})();

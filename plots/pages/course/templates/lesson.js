"use strict";
// Predict before reveal: what follows a question in its section is shown once somebody has committed to an answer.
(() => {
const reveal = (form, verdict) => {
  form.classList.remove("waiting");
  form.querySelector(".verdict").textContent = verdict;
  for (const input of form.querySelectorAll("input, button")) input.disabled = true;
  form.querySelector(".revealed").focus();
};

// What was answered, and whether it holds; nothing where there is no answer yet.
const judged = (form) => {
  const chosen = form.querySelector("input[type=radio]:checked");
  if (chosen) return chosen.value === form.dataset.right ? "Your prediction holds." : "Your prediction does not hold.";
  const text = form.querySelector("input[type=text]")?.value.trim().replace("−", "-").replace(",", ".");
  const number = Number(text);
  if (!text || Number.isNaN(number)) return null;
  const value = Number(form.dataset.value), off = Math.abs(number - value) / Math.abs(value);
  if (off <= Number(form.dataset.within)) return "Your prediction holds.";
  return number > value ? "It is less than you predicted." : "It is more than you predicted.";
};

for (const form of document.querySelectorAll(".predict")) {
  form.classList.add("waiting");
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const verdict = judged(form);
    form.querySelector(".complaint").textContent = verdict ? "" : `Commit to an answer first: ${form.querySelector("input[type=text]") ? "write a number" : "choose one"}.`;
    if (verdict) reveal(form, verdict);
  });
  form.querySelector(".skip").addEventListener("click", () => reveal(form, "Not predicted."));
}

// Where the program serves this page, the lesson's scene has sliders.
const served = location.protocol === "http:" && location.pathname.match(/^\/course\/(\w+)\//);
if (served) {
  const place = document.getElementById("sliders"), frame = document.createElement("iframe");
  const asked = { token: served[1], lesson: place.dataset.lesson, within: "" };
  Object.assign(frame, { className: "live", title: "The scene of this lesson, with sliders", loading: "lazy", src: "/?" + new URLSearchParams(asked) });
  place.querySelector(".asleep").replaceWith(frame);
}

document.getElementById("large")?.addEventListener("click", (event) => {
  event.target.setAttribute("aria-pressed", document.documentElement.classList.toggle("large"));
});
})();

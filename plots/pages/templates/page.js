"use strict";
// Sorts the table of runs by the column whose heading is chosen; rows without a value stay last.
const value = (row, column) => row.cells[column].dataset.value ?? row.cells[column].textContent;

const compare = (a, b) => {
  if (a === "" || b === "") return (a === "") - (b === "");
  const difference = Number(a) - Number(b);
  return Number.isNaN(difference) ? a.localeCompare(b, "en", { numeric: true }) : difference;
};

const sort = (heading) => {
  const descending = heading.getAttribute("aria-sort") === "ascending";
  const body = heading.closest("table").tBodies[0];
  const rows = Array.from(body.rows);
  const empty = (row) => value(row, heading.cellIndex) === "";
  rows.sort((a, b) => {
    const order = compare(value(a, heading.cellIndex), value(b, heading.cellIndex));
    return descending && !empty(a) && !empty(b) ? -order : order;
  });
  for (const other of heading.parentElement.cells) other.removeAttribute("aria-sort");
  heading.setAttribute("aria-sort", descending ? "descending" : "ascending");
  body.append(...rows);
};

for (const button of document.querySelectorAll("thead button"))
  button.addEventListener("click", () => sort(button.closest("th")));

// On a narrow screen a row is a card, whose cells say what they are.
for (const table of document.querySelectorAll("main table:not(.values)")) {
  const names = Array.from(table.tHead.rows[0].cells, (cell) => cell.textContent);
  for (const row of table.tBodies[0].rows)
    Array.from(row.cells).forEach((cell, i) => { cell.dataset.label = names[i]; });
  table.classList.add("cards");
}

// A table that is wider than its place says that it scrolls.
const wide = new ResizeObserver((entries) => {
  for (const { target } of entries) target.classList.toggle("cut", target.scrollWidth > target.clientWidth + 1);
});
for (const place of document.querySelectorAll(".scroll")) wide.observe(place);

// A link to a part that is folded opens it.
const unfold = () => {
  const part = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (part?.tagName === "DETAILS") { part.open = true; part.scrollIntoView(); }
};
addEventListener("hashchange", unfold);
unfold();

// Answers are read on paper too.
addEventListener("beforeprint", () => {
  for (const part of document.querySelectorAll("details.question")) part.open = true;
});

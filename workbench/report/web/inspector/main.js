// Makes the tree inspectors of report.html, each when it is first scrolled near, or printed.

import { Inspector } from "./inspector.js";
import { canDraw } from "./tree_view.js";

function say(place, text) {
  const message = place.querySelector(".message");
  message.textContent = text;
  message.hidden = false;
  place.querySelector(".controls").hidden = true;
  place.querySelector(".views").hidden = true;
}

const places = [...document.querySelectorAll("[data-inspector]")];
const made = new Set();

function make(place) {
  if (made.has(place)) return;
  made.add(place);
  try {
    new Inspector(place);
  } catch (error) {
    say(place, `The tree inspector cannot be drawn: ${error.message}`);
    console.error(error);
  }
}

if (canDraw()) {
  const observer = new IntersectionObserver(
    (entries) => entries.filter((entry) => entry.isIntersecting).forEach((entry) => make(entry.target)),
    { rootMargin: "300px" },
  );
  for (const place of places) observer.observe(place);
  window.addEventListener("beforeprint", () => places.forEach(make));
} else {
  const text =
    "The tree inspector needs WebGL 2, which this browser lacks or has turned off. " +
    "All else on this page works without it.";
  for (const place of places) say(place, text);
}

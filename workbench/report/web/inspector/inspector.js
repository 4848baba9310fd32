// The tree inspector: one or two trees over the scene, level by level, seen by one camera.

import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import { gradient, themes } from "./colours.js";
import { readInspector } from "./data.js";
import { TreeView, makeOutline } from "./tree_view.js";

const dark = window.matchMedia("(prefers-color-scheme: dark)");
const turn = Math.PI / 36; // a key's step

const shareText = (share) => `${Number((100 * share).toPrecision(2))} % of the tree’s cost`;
const countText = (count) => `${count.toLocaleString("en")} primitive${count === 1 ? "" : "s"}`;

// A camera that shows as much from side to side in every view as the picture of the scene does.
class FittingCamera extends PerspectiveCamera {
  constructor(fov) {
    super(fov, 16 / 9);
    this.side = Math.tan((fov * Math.PI) / 360) * this.aspect;
  }

  fit(aspect) {
    this.aspect = aspect;
    this.fov = (Math.atan(this.side / Math.min(aspect, 16 / 9)) * 360) / Math.PI;
    this.updateProjectionMatrix();
  }
}

export class Inspector {
  constructor(place) {
    this.place = place;
    this.data = readInspector(JSON.parse(document.getElementById(place.dataset.inspector).textContent));
    const outline = makeOutline(this.data);
    this.views = [...place.querySelectorAll("figure")].map(
      (figure, i) => new TreeView(figure, this.data.trees[i], outline),
    );
    this.makeCamera();
    for (const view of this.views) this.listenTo(view.canvas);
    this.listenToControls();
    this.isPrinted = false;
    this.update();
  }

  makeCamera() {
    this.camera = new FittingCamera(this.data.fov);
    this.target = new Vector3(...this.data.target);
    this.camera.up.set(...this.data.up).normalize();
    this.resetCamera();
  }

  resetCamera() {
    this.camera.position.set(...this.data.eye);
    this.target.set(...this.data.target);
    this.camera.lookAt(this.target);
  }

  listenTo(canvas) {
    const orbit = new OrbitControls(this.camera, canvas);
    orbit.target = this.target; // shared: the other view's controls go on from here
    orbit.update();
    orbit.enableZoom = false; // or the page could not be scrolled over it
    canvas.style.touchAction = "pan-y";
    canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
    canvas.addEventListener("focus", () => (orbit.enableZoom = true));
    canvas.addEventListener("blur", () => (orbit.enableZoom = false));
    canvas.addEventListener("keydown", (event) => this.onKey(event));
    orbit.addEventListener("change", () => this.draw());
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  listenToControls() {
    const control = (name) => this.place.querySelector(`[name=${name}]`);
    this.controls = {
      level: control("level"),
      colour: control("colour"),
      scene: control("scene"),
      empty: control("empty"),
    };
    this.output = this.place.querySelector("output");
    for (const input of Object.values(this.controls)) {
      input.addEventListener("input", () => this.update());
    }
    control("reset").addEventListener("click", () => {
      this.resetCamera();
      this.draw();
    });
    dark.addEventListener("change", () => this.update());
    const print = (isPrinted) => {
      this.isPrinted = isPrinted;
      this.update();
      this.drawNow();
    };
    window.addEventListener("beforeprint", () => print(true));
    window.addEventListener("afterprint", () => print(false));
  }

  onKey(event) {
    const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const zooms = { "+": 0.9, "=": 0.9, "-": 1 / 0.9 };
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key in turns) this.turnBy(...turns[event.key]);
    else if (event.key in zooms) this.offset((offset) => offset.multiplyScalar(zooms[event.key]));
    else if (event.key === "Home") this.resetCamera();
    else return;
    event.preventDefault();
    this.draw();
  }

  // Moves the eye around the target.
  offset(change) {
    const offset = this.camera.position.clone().sub(this.target);
    change(offset);
    this.camera.position.copy(this.target).add(offset);
    this.camera.lookAt(this.target);
  }

  turnBy(sideways, upwards) {
    const up = this.camera.up;
    this.offset((offset) => {
      offset.applyAxisAngle(up, sideways * turn);
      const polar = offset.angleTo(up) + upwards * turn;
      if (polar < 0.01 || polar > Math.PI - 0.01) return;
      offset.applyAxisAngle(up.clone().cross(offset).normalize(), upwards * turn);
    });
  }

  get theme() {
    return dark.matches && !this.isPrinted ? themes.dark : themes.light;
  }

  // Least and greatest of a measure at a level, over all trees shown: they share their colours.
  ends(number, measure) {
    const values = this.views.flatMap((view) => [...(view.levels[number]?.[measure] ?? [])]);
    const positive = values.filter((value) => value > 0);
    if (positive.length === 0) return { low: 1, high: 1 };
    const less = (a, b) => Math.min(a, b);
    const more = (a, b) => Math.max(a, b);
    return { low: positive.reduce(less), high: positive.reduce(more) };
  }

  update() {
    const number = Number(this.controls.level.value);
    const measure = this.controls.colour.value;
    const ends = this.ends(number, measure);
    for (const view of this.views) {
      view.setLevel(number, measure, ends, this.theme, this.controls.empty.checked);
    }
    this.output.textContent = String(number);
    const legend = this.place.querySelector(".legend");
    const text = measure === "shares" ? shareText : countText;
    legend.hidden = false;
    legend.firstElementChild.textContent = text(ends.low);
    legend.lastElementChild.textContent = text(ends.high);
    legend.querySelector(".bar").style.backgroundImage = gradient(this.theme);
    this.draw();
  }

  draw() {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => this.drawNow());
  }

  drawNow() {
    this.isWaiting = false;
    const distance = this.camera.position.distanceTo(this.target);
    this.camera.near = Math.max(distance / 1000, 1e-6); // a scene may be one point
    this.camera.far = distance + 4;
    for (const view of this.views) view.draw(this.camera, this.theme, this.controls.scene.checked);
    this.place.dataset.drawn = "yes";
  }
}

// One tree over the scene, drawn into one canvas. All views of a page share one WebGL context, for
// browsers allow only a few: a picture is drawn there and copied to the view's own canvas.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  HemisphereLight,
  LinearSRGBColorSpace,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  Points,
  PointsMaterial,
  Scene,
  WebGLRenderer,
} from "three";

import { writeColour } from "./colours.js";

const pointSize = 2.4; // pixels: as large as the gaps between the points of a scene in view

let renderer = null;

// Whether this browser can draw at all; asked without three.js, which would log an error.
export function canDraw() {
  const context = document.createElement("canvas").getContext("webgl2");
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return context !== null;
}

function sharedRenderer() {
  if (renderer === null) {
    renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    renderer.outputColorSpace = LinearSRGBColorSpace; // colours are given as they are shown
  }
  return renderer;
}

// The scene as three.js draws it: a mesh, or points with their shades.
export function makeOutline(data) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(data.positions, 3));
  if (data.indices !== null) {
    geometry.setIndex(new BufferAttribute(data.indices, 1));
    return new Mesh(geometry, new MeshLambertMaterial({ flatShading: true, side: 2 }));
  }
  const shades = Uint8Array.from({ length: 3 * data.shades.length }, (_, i) => data.shades[Math.floor(i / 3)]);
  geometry.setAttribute("color", new BufferAttribute(shades, 3, true));
  return new Points(geometry, new PointsMaterial({ vertexColors: true, sizeAttenuation: false }));
}

// The ends of a box's twelve edges: bits 0, 1, 2 choose the upper end in x, y, z.
const edges = [0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7];

function writeEdges(box, out, at) {
  edges.forEach((corner, i) => {
    for (let axis = 0; axis < 3; ++axis) {
      out[at + 3 * i + axis] = box[axis + ((corner >> axis) & 1 ? 3 : 0)];
    }
  });
}

export class TreeView {
  constructor(figure, levels, outline) {
    this.canvas = figure.querySelector("canvas");
    this.readout = figure.querySelector(".readout");
    this.levels = levels;
    this.outline = outline;
    this.scene = new Scene();
    this.sky = new HemisphereLight(0xffffff, 0x555555, 2.2);
    this.sun = new DirectionalLight(0xffffff, 1.2);
    this.sun.position.set(0.4, 0.7, 1);
    this.lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ vertexColors: true }));
    this.lines.frustumCulled = false;
    this.scene.add(this.sky, this.sun, this.lines);
  }

  // Draws the cells of a level, coloured by `measure` ("shares" or "counts") between the ends.
  setLevel(number, measure, ends, theme, withEmpty) {
    const level = this.levels[number];
    this.lines.geometry.dispose();
    this.lines.geometry = new BufferGeometry();
    this.readout.textContent = this.describe(level, number, withEmpty);
    this.lines.visible = level !== undefined;
    if (level === undefined) return;
    const chosen = [...level.counts.keys()].filter((i) => withEmpty || level.counts[i] > 0);
    const positions = new Float32Array(chosen.length * 72);
    const colours = new Float32Array(chosen.length * 72);
    chosen.forEach((cell, i) => {
      writeEdges(level.boxes.subarray(6 * cell, 6 * cell + 6), positions, 72 * i);
      const value = Math.max(level[measure][cell], ends.low);
      const span = Math.log(ends.high / ends.low);
      const share = span > 0 ? Math.log(value / ends.low) / span : 1;
      for (let k = 0; k < 24; ++k) writeColour(theme, share, colours, 72 * i + 3 * k);
    });
    this.lines.geometry.setAttribute("position", new BufferAttribute(positions, 3));
    this.lines.geometry.setAttribute("color", new BufferAttribute(colours, 3));
  }

  describe(level, number, withEmpty) {
    if (level === undefined) return `The tree ends at level ${this.levels.length - 1}.`;
    const filled = level.counts.filter((count) => count > 0).length;
    const all = level.cellCount.toLocaleString("en");
    const empty = level.emptyCount.toLocaleString("en");
    const drawn = (withEmpty ? level.counts.length : filled).toLocaleString("en");
    const chosen = level.counts.length < level.cellCount ? ", evenly chosen" : "";
    return `Level ${number} has ${all} nodes, ${empty} of them empty leaves; drawn: ${drawn}${chosen}.`;
  }

  draw(camera, theme, withScene) {
    const ratio = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    const shared = sharedRenderer();
    shared.setSize(width, height, false);
    this.scene.background = new Color().setStyle(theme.paper, LinearSRGBColorSpace);
    this.outline.visible = withScene;
    this.outline.material.color.setScalar(theme.scene);
    if (this.outline.material.size) this.outline.material.size = pointSize * ratio;
    this.scene.add(this.outline); // takes it from the other view
    camera.fit(width / height);
    shared.render(this.scene, camera);
    this.canvas.getContext("2d").drawImage(shared.domElement, 0, 0);
  }
}

// Reads what workbench/report/inspector_data.h describes. Lengths become fractions of the scene's
// longest side, so that scenes of every size are drawn alike.

const logRange = 40;
const most = 65535;

function bytesOf(base64) {
  return Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
}

function wordsOf(base64) {
  const bytes = bytesOf(base64);
  const view = new DataView(bytes.buffer);
  return Uint16Array.from({ length: bytes.length / 2 }, (_, i) => view.getUint16(2 * i, true));
}

function indicesOf(base64, count) {
  const bytes = bytesOf(base64);
  const indices = new Uint32Array(count);
  let previous = 0;
  for (let i = 0, at = 0; i < count; ++i) {
    let code = 0;
    let scale = 1; // shifts would end at 31 bits
    let byte;
    do {
      byte = bytes[at++];
      code += (byte & 127) * scale;
      scale *= 128;
    } while (byte & 128);
    previous += code % 2 === 0 ? code / 2 : -(code + 1) / 2;
    indices[i] = previous;
  }
  return indices;
}

// Levels as { cellCount, emptyCount, boxes, shares, counts }; six numbers a box.
function levelsOf(tree, size) {
  const boxes = Float32Array.from(wordsOf(tree.boxes), (word, i) => (word / most) * size[i % 3]);
  const shares = Float64Array.from(wordsOf(tree.shares), (word) =>
    word === 0 ? 0 : 2 ** ((word / most - 1) * logRange),
  );
  const counts = Float64Array.from(wordsOf(tree.counts), (word) =>
    Math.round(2 ** ((word / most) * logRange) - 1),
  );
  let first = 0;
  return tree.levels.map(([cellCount, emptyCount, shown]) => {
    const end = first + shown;
    const level = {
      cellCount,
      emptyCount,
      boxes: boxes.subarray(6 * first, 6 * end),
      shares: shares.subarray(first, end),
      counts: counts.subarray(first, end),
    };
    first = end;
    return level;
  });
}

export function readInspector(data) {
  const { lower, upper } = data.bounds;
  const longest = Math.max(...upper.map((high, i) => high - lower[i])) || 1;
  const size = upper.map((high, i) => (high - lower[i]) / longest);
  const toUnit = (point) => point.map((x, i) => (x - lower[i]) / longest);
  return {
    size,
    eye: toUnit(data.viewpoint.eye),
    target: toUnit(data.viewpoint.look_at),
    up: data.viewpoint.up,
    fov: data.viewpoint.fov,
    positions: Float32Array.from(wordsOf(data.positions), (word, i) => (word / most) * size[i % 3]),
    shades: data.shades === undefined ? null : bytesOf(data.shades),
    indices: data.indices === undefined ? null : indicesOf(data.indices, data.index_count),
    trees: data.trees.map((tree) => levelsOf(tree, size)),
  };
}

// The colours of cells: equal steps look equal, also to colour-blind eyes and in grey; great values
// stand out most, on dark paper and on light.
// Source: [Inferno2015] (viridis, and inferno from its light end).

export const themes = {
  dark: {
    paper: "#14171b",
    scene: 0.62, // brightness of the scene's shades
    stops: ["#3b528b", "#2a788e", "#22a884", "#7ad151", "#fde725"],
  },
  light: {
    paper: "#ffffff",
    scene: 0.85,
    stops: ["#f7b32b", "#ed6925", "#bb3754", "#781c6d", "#210c4a"],
  },
};

export function gradient(theme) {
  return `linear-gradient(to right, ${theme.stops.join(", ")})`;
}

const channels = (colour) => [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16) / 255);

// Writes the colour of a share in [0, 1] to three numbers of `out` from `at` on.
export function writeColour(theme, share, out, at) {
  const place = Math.min(Math.max(share, 0), 1) * (theme.stops.length - 1);
  const below = Math.min(Math.floor(place), theme.stops.length - 2);
  const [low, high] = [channels(theme.stops[below]), channels(theme.stops[below + 1])];
  for (let i = 0; i < 3; ++i) out[at + i] = low[i] + (high[i] - low[i]) * (place - below);
}

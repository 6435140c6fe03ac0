// Numbers and units as the panel of the window writes them.

export function short(x) {
  if (x === null || x === undefined || Number.isNaN(x)) return "–";
  if (x === 0) return "0";
  const size = Math.abs(x);
  const text = size >= 1e5 || size < 1e-3 ? x.toExponential(2).replace(/\.?0+e/, "e").replace("e+", "e") : String(Number(x.toPrecision(3)));
  return text.replace("-", "−").replace("e−", "e-");
}

// In three digits with an SI prefix: "12.3 ms".
export function si(x, unit) {
  if (x === 0) return `0 ${unit}`;
  const thousands = Math.min(Math.max(Math.floor(Math.log10(Math.abs(x) * (1 + 1e-9)) / 3), -4), 3);
  return `${short(x / 1000 ** thousands)} ${["p", "n", "µ", "m", "", "k", "M", "G"][thousands + 4]}${unit}`;
}

export function grouped(n) { return Math.round(n).toString().replace(/\B(?=(\d{3})+$)/g, "\u00a0"); }

export function unit_text(unit) {
  if (unit === "1" || !unit) return "";
  return unit === "grain masses" ? "m_g" : unit.replace("sqrt", "√");
}

// Text with what stands behind an underscore set as a subscript, as in F_g.
export function typeset(text) {
  return text.split(/(_[A-Za-z]+)/).filter(Boolean).map((piece) => (piece[0] === "_" ? element("sub", {}, piece.slice(1)) : piece));
}

export function duration(seconds) {
  if (seconds < 60) return Math.ceil(seconds) + " s";
  if (seconds < 3600) return Math.round(seconds / 60) + " min";
  return (seconds / 3600).toFixed(1) + " h";
}

// A sentence keeps the underscores of its symbols and keys, a name has spaces for them.
export function sentence(text) { return text[0].toUpperCase() + text.slice(1); }
export function capitalised(text) { return sentence(text).replaceAll("_", " "); }

// A column of series.csv in the words of the panel.
export function quantity(name) { return capitalised(name.replace("bond_fraction", "share")); }

// Multiples of the smallest 1, 2 or 5 times a power of ten of which no more than `most` fit into a span.
export function nice_step(span, most) {
  const power = 10 ** Math.floor(Math.log10(span / most));
  return power * [1, 2, 5, 10].find((first) => first * power * most >= span * (1 - 1e-9));
}

// 1, 2 or 5 times a power of ten, not above x.
export function nice_below(x) {
  const power = 10 ** Math.floor(Math.log10(x)), first = x / power;
  return power * (first >= 5 ? 5 : first >= 2 ? 2 : 1);
}

// An element with these properties and children.
export function element(name, properties = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key in made && !key.startsWith("aria")) made[key] = value;
    else made.setAttribute(key, value);
  }
  made.append(...children.filter((c) => c !== null));
  return made;
}

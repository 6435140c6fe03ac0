// Histories over time or over the way of an intruder: small plots with one cursor, which is a time.
import {element, nice_step, quantity, sentence, short, typeset, unit_text} from "./numbers.js";

const kFirst = ["active_bond_fraction", "coordination", "depth"];
// What a plot may be over, and what a scene with a driven intruder shows first.
const kOver = {time: "time", depth: "depth", intruder_angle: "angle", piston_x: "distance"};
const kOfDrive = {penetrate: ["resistance", "depth"], vane: ["intruder_torque", "intruder_angle"],
  slide: ["shear_force", "piston_x"]};
const kRoom = {left: 46, right: 8, top: 7, bottom: 18};
const kMostSteps = 3;  // between the ticks of the ordinate
const kTickRoom = 45;  // of a tick of the abscissa [px]
const kNearATick = 0.1;  // steps by which a curve may pass the last tick

const kShortest = 0.01;  // way or time that is shown, as in the window

// Round numbers from low to high.
function multiples(step, low, high) {
  const all = [];
  for (let k = Math.ceil(low / step - 1e-9); k <= high / step + 1e-9; ++k) all.push(Number((k * step).toPrecision(12)));
  return all;
}

export class Plots {
  constructor(part) {
    this.part = part;
    this.cursor = null;  // time that is pointed at
    this.moment = null;  // time of a run that is walked through, where nothing is pointed at
    this.message = null;
    this.plots = kFirst.map((name, i) => this.make(name, i));
    part.append(...this.plots.map((p) => p.element));
    new ResizeObserver(() => this.draw()).observe(part);
  }

  make(name, i) {
    const select = element("select", {"aria-label": `Quantity of plot ${i + 1}`});
    const over = element("select", {className: "over", "aria-label": `Horizontal axis of plot ${i + 1}`});
    const output = element("output", {}), canvas = element("canvas", {tabIndex: 0, role: "img"});
    const head = element("div", {}, select, output);
    const plot = {name, over: "time", select, over_select: over, output, canvas, element: element("div", {className: "plot"}, head, canvas, over)};
    select.addEventListener("change", () => {
      plot.name = select.value;
      this.draw();
    });
    over.addEventListener("change", () => {
      plot.over = over.value;
      this.draw();
    });
    canvas.addEventListener("pointermove", (e) => this.point(plot, e.offsetX));
    canvas.addEventListener("pointerleave", () => this.set_cursor(null));
    canvas.addEventListener("keydown", (e) => {
      const by = {ArrowLeft: -1, ArrowRight: 1}[e.key];
      if (!by || !this.message) return;
      e.preventDefault();
      const last = this.message.time.length - 1, now = (this.cursor ?? this.moment) === null ? last : this.nearest(this.cursor ?? this.moment);
      this.set_cursor(this.message.time[Math.max(0, Math.min(last, now + by))]);
    });
    canvas.addEventListener("blur", () => this.set_cursor(null));
    return plot;
  }

  show(message) {
    this.message = message;
    const names = message.columns.map((c) => c.name).filter((n) => n !== "time" && n !== "step");
    for (const plot of this.plots) {
      if (plot.names === names.join()) continue;
      plot.names = names.join();
      const all = names.includes(plot.name) ? names : [plot.name, ...names];
      plot.select.replaceChildren(...all.map((n) => element("option", {value: n}, quantity(n))));
      plot.select.value = plot.name;
      const overs = Object.keys(kOver).filter((n) => n === "time" || n === plot.over || names.includes(n));
      plot.over_select.replaceChildren(...overs.map((n) => element("option", {value: n}, `${kOver[n]} [${this.unit_of(n)}]`)));
      plot.over_select.value = plot.over;
    }
    this.draw();
  }

  unit_of(name) { return unit_text(this.message.columns.find((c) => c.name === name)?.unit ?? "sqrt(d/g)"); }

  // The phases of a scene: the last plots are of its drives.
  set_phases(phases) {
    if (this.phases === phases.join()) return;
    this.phases = phases.join();
    const drives = [...new Set(phases)].filter((p) => kOfDrive[p]).map((p) => kOfDrive[p]);
    this.plots.forEach((plot, i) => {
      const drive = drives[i - (this.plots.length - drives.length)];
      if (!drive && plot.over === "time") return;
      [plot.name, plot.over] = drive ?? [kFirst[i], "time"];
      plot.names = null;
    });
    if (this.message) this.show(this.message);
  }

  // Index of the sample whose x, a time or a way, is nearest.
  nearest(x, over = "time") {
    const values = this.message[over];
    let best = 0;
    for (let i = 1; i < values.length; ++i) if (!(Math.abs(values[best] - x) <= Math.abs(values[i] - x))) best = i;
    return best;
  }

  point(plot, x) {
    if (!this.message || !plot.scale) return;
    const at = plot.scale.from + ((x - kRoom.left) / plot.scale.width) * (plot.scale.to - plot.scale.from);
    this.set_cursor(plot.over === "time" ? at : this.message.time[this.nearest(at, plot.over)]);
  }

  set_cursor(time) {
    this.cursor = time;
    this.draw();
  }

  set_moment(time) {
    if (this.moment === time) return;
    this.moment = time;
    this.draw();
  }

  draw() {
    if (!this.message) return;
    const style = getComputedStyle(document.documentElement);
    const colours = Object.fromEntries(["ink", "faint", "line", "curve", "accent"].map((n) => [n, style.getPropertyValue("--" + n)]));
    for (const plot of this.plots) if (plot.canvas.clientWidth > 0) this.draw_plot(plot, colours);
  }

  draw_plot(plot, colours) {
    const {canvas} = plot, ratio = window.devicePixelRatio || 1, [w, h] = [canvas.clientWidth, canvas.clientHeight];
    canvas.width = Math.round(w * ratio);
    canvas.height = Math.round(h * ratio);
    const g = canvas.getContext("2d"), column = this.message.columns.find((c) => c.name === plot.name);
    g.scale(ratio, ratio);
    g.font = "12px Roboto, sans-serif";
    const times = this.message.time ?? [], values = this.message[plot.name] ?? [];
    const places = this.message[plot.over] ?? [];
    const shown = values.map((v, i) => Number.isFinite(v) && Number.isFinite(places[i]));
    let low = Infinity, high = -Infinity, from = Infinity, to = -Infinity;
    values.forEach((v, i) => {
      if (shown[i]) [low, high, from, to] = [Math.min(low, v), Math.max(high, v), Math.min(from, places[i]), Math.max(to, places[i])];
    });
    if (plot.over === "time" && times.length) [from, to] = [times[0], times.at(-1)];
    plot.select.title = column ? sentence(column.help) : "";
    if (!(low <= high)) {
      plot.scale = null;
      plot.output.textContent = "";
      g.fillStyle = colours.faint;
      g.fillText("no values yet", kRoom.left, h / 2);
      return canvas.setAttribute("aria-label", `${quantity(plot.name)}: no values yet`);
    }
    if (low === high) [low, high] = [low - (Math.abs(low) || 1) / 2, high + (Math.abs(high) || 1) / 2];
    to = Math.max(to, from + kShortest);
    const step = nice_step(high - low, kMostSteps);
    [low, high] = [Math.min(low, Math.floor(low / step + kNearATick) * step), Math.max(high, Math.ceil(high / step - kNearATick) * step)];
    const width = w - kRoom.left - kRoom.right, height = h - kRoom.top - kRoom.bottom;
    plot.scale = {from, to, width};
    const x_of = (x) => kRoom.left + ((x - from) / (to - from)) * width, y_of = (v) => kRoom.top + (1 - (v - low) / (high - low)) * height;
    g.strokeStyle = colours.line;
    g.fillStyle = colours.faint;
    const line = (x0, y0, x1, y1) => {
      g.beginPath();
      g.moveTo(x0, y0);
      g.lineTo(x1, y1);
      g.stroke();
    };
    g.textAlign = "right";
    for (const v of multiples(step, low, high)) {
      const y = Math.round(y_of(v)) + 0.5;
      line(kRoom.left, y, w - kRoom.right, y);
      g.fillText(short(v), kRoom.left - 5, y + 4);
    }
    // What it is over stands at the right end.
    const free = plot.over_select.offsetLeft - canvas.offsetLeft;
    g.textAlign = "center";
    for (const v of multiples(nice_step(to - from, Math.max(2, Math.floor(width / kTickRoom))), from, to)) {
      const x = Math.round(x_of(v)) + 0.5, text = short(v);
      line(x, h - kRoom.bottom, x, h - kRoom.bottom + 3);
      if (x + g.measureText(text).width / 2 < free) g.fillText(text, x, h - 3);
    }
    g.strokeStyle = colours.curve;
    g.lineWidth = 1.5;
    g.beginPath();
    let open = false;
    values.forEach((v, i) => {
      if (shown[i]) g[open ? "lineTo" : "moveTo"](x_of(places[i]), y_of(v));
      open = shown[i];
    });
    g.stroke();
    const cursor = this.cursor ?? this.moment;
    const at = cursor === null ? values.length - 1 : this.nearest(cursor), unit = unit_text(column.unit);
    const text = `${short(values[at])}${unit ? " " + unit : ""}`;
    plot.output.replaceChildren(...typeset(cursor === null ? text : `${text} at ${short(times[at])}`));
    canvas.setAttribute("aria-label", `${quantity(plot.name)} over ${kOver[plot.over]}, ${plot.output.textContent}`);
    if (cursor === null || !Number.isFinite(places[at])) return;
    g.strokeStyle = colours.accent;
    g.lineWidth = 1;
    g.beginPath();
    g.moveTo(Math.round(x_of(places[at])) + 0.5, kRoom.top);
    g.lineTo(Math.round(x_of(places[at])) + 0.5, h - kRoom.bottom);
    g.stroke();
  }
}

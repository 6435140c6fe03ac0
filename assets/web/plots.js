// Time histories: small plots with one cursor.
import {capitalised, element, short, unit_text} from "./numbers.js";

const kFirst = ["active_bond_fraction", "coordination", "depth"];
const kRoom = {left: 46, right: 8, top: 6, bottom: 16};

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
    const output = element("output", {}), canvas = element("canvas", {tabIndex: 0, role: "img"});
    const plot = {name, select, output, canvas, element: element("div", {className: "plot"}, element("div", {}, select, output), canvas)};
    select.addEventListener("change", () => {
      plot.name = select.value;
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
      plot.select.replaceChildren(...all.map((n) => element("option", {value: n}, capitalised(n))));
      plot.select.value = plot.name;
    }
    this.draw();
  }

  nearest(time) {
    const {time: times} = this.message;
    let best = 0;
    for (let i = 1; i < times.length; ++i) if (Math.abs(times[i] - time) < Math.abs(times[best] - time)) best = i;
    return best;
  }

  point(plot, x) {
    if (!this.message || !plot.scale) return;
    this.set_cursor(plot.scale.from + ((x - kRoom.left) / plot.scale.width) * (plot.scale.to - plot.scale.from));
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
    let low = Infinity, high = -Infinity;
    for (const v of values) if (Number.isFinite(v)) [low, high] = [Math.min(low, v), Math.max(high, v)];
    plot.select.title = column ? capitalised(column.help) : "";
    if (!(low <= high)) {
      plot.scale = null;
      plot.output.textContent = "";
      g.fillStyle = colours.faint;
      g.fillText("no values yet", kRoom.left, h / 2);
      return canvas.setAttribute("aria-label", `${capitalised(plot.name)}: no values yet`);
    }
    if (low === high) [low, high] = [low - (Math.abs(low) || 1) / 2, high + (Math.abs(high) || 1) / 2];
    const from = times[0], to = Math.max(times.at(-1), from + 1e-9);
    const width = w - kRoom.left - kRoom.right, height = h - kRoom.top - kRoom.bottom;
    plot.scale = {from, to, width};
    const x_of = (t) => kRoom.left + ((t - from) / (to - from)) * width, y_of = (v) => kRoom.top + (1 - (v - low) / (high - low)) * height;
    g.strokeStyle = colours.line;
    g.fillStyle = colours.faint;
    g.textAlign = "right";
    for (const v of [low, high]) {
      const y = Math.round(y_of(v)) + 0.5;
      g.beginPath();
      g.moveTo(kRoom.left, y);
      g.lineTo(w - kRoom.right, y);
      g.stroke();
      g.fillText(short(v), kRoom.left - 5, y + (v === low ? 0 : 8));
    }
    g.fillText(short(to) + " √(d/g)", w - kRoom.right, h - 3);
    g.textAlign = "left";
    g.fillText(short(from), kRoom.left, h - 3);
    g.strokeStyle = colours.curve;
    g.lineWidth = 1.5;
    g.beginPath();
    let open = false;
    values.forEach((v, i) => {
      if (Number.isFinite(v)) g[open ? "lineTo" : "moveTo"](x_of(times[i]), y_of(v));
      open = Number.isFinite(v);
    });
    g.stroke();
    const cursor = this.cursor ?? this.moment;
    const at = cursor === null ? values.length - 1 : this.nearest(cursor), unit = unit_text(column.unit);
    const text = `${short(values[at])}${unit ? " " + unit : ""}`;
    plot.output.textContent = cursor === null ? text : `${text} at ${short(times[at])}`;
    canvas.setAttribute("aria-label", `${capitalised(plot.name)} over time, ${plot.output.textContent}`);
    if (cursor === null) return;
    g.strokeStyle = colours.accent;
    g.lineWidth = 1;
    g.beginPath();
    g.moveTo(Math.round(x_of(times[at])) + 0.5, kRoom.top);
    g.lineTo(Math.round(x_of(times[at])) + 0.5, h - kRoom.bottom);
    g.stroke();
  }
}

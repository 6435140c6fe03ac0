// The picture: the newest frame through the camera, with legend, scale bar and rings over it.
import {Camera, Gestures, first_window, kZoomOfAKey} from "./camera.js";
import {draw, draws_bars, shows_sides} from "./drawing.js";
import {show_inspection, show_tooltip} from "./inspection.js";
import {element, nice_below, short, si, typeset} from "./numbers.js";
import {Painter} from "./painter.js";

const by_id = (id) => document.getElementById(id);
const kCameraRests = 200;  // until its place is told to the server [ms]
const css = ([r, g, b]) => `rgb(${r} ${g} ${b})`;

// Whether a place from the centre of a body is in this part of it: inside its corners, or within its rounding around them.
function holds({corners, radius}, x, y) {
  const edges = corners.map(([px, py], k) => {
    const [qx, qy] = corners[(k + 1) % corners.length], ex = qx - px, ey = qy - py, square = ex * ex + ey * ey;
    const s = square > 0 ? Math.min(Math.max(((x - px) * ex + (y - py) * ey) / square, 0), 1) : 0;
    return {left: ex * (y - py) - ey * (x - px) > 0, away: Math.hypot(x - px - s * ex, y - py - s * ey)};
  });
  return edges.some(({away}) => away <= radius) || (corners.length > 2 && edges.every(({left}) => left));
}

export class Picture {
  constructor(connection, shaders, controls) {
    Object.assign(this, {connection, controls, frame: null, own: null, hovered: null, held: null});
    this.canvas = by_id("picture");
    this.shaders = shaders;
    this.gestures = new Gestures(this.canvas, this);
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    for (const button of document.querySelectorAll("#camera button")) button.addEventListener("click", () => this.press(button.dataset.do));
  }

  press(what) {
    if (what === "pull") return this.toggle_pull();
    if (!this.frame) return;
    if (what === "in" || what === "out") return this.gestures.zoom(what === "in" ? kZoomOfAKey : 1 / kZoomOfAKey);
    this.fit(what);
  }

  resize() {
    const ratio = window.devicePixelRatio || 1, {clientWidth, clientHeight} = this.canvas;
    const [width, height] = [clientWidth, clientHeight].map((x) => Math.max(64, Math.round(x * ratio)));
    if (this.canvas.width === width && this.canvas.height === height) return;
    [this.canvas.width, this.canvas.height] = [width, height];
    if (this.frame?.png) this.tell_size();
    if (this.own) this.look(this.own);
    this.redraw();
  }

  size() { return {width: this.canvas.width, height: this.canvas.height}; }
  // Where the server draws the pictures.
  tell_size() { this.controls.tried("view", this.size()); }

  show(frame) {
    if (frame.png && !this.frame) this.tell_size();
    const other = this.frame && this.frame.scene !== frame.scene;
    if (other || (frame.follows && !this.looking)) this.own = null;
    this.frame = frame;
    if (!this.own && !frame.fitted && !frame.follows) this.own = frame.window;
    this.redraw(true);
  }

  redraw(is_new = false) {
    this.acknowledge ||= is_new;
    if (this.asked || !this.frame) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = null;
      if (this.frame) this.paint();
      if (this.acknowledge) this.connection.drawn();
      this.acknowledge = false;
    });
  }

  camera() {
    if (!this.frame) return null;
    return new Camera(this.frame, this.own ?? first_window(this.frame), this.canvas.width, this.canvas.height);
  }

  paint() {
    const camera = this.camera(), {frame} = this;
    if (frame.png) this.paint_pixels(frame.png);
    else (this.painter ??= new Painter(this.canvas, this.shaders)).paint(draw(frame, camera));
    this.canvas.setAttribute("aria-label", `${frame.scene}: ${frame.bodies} bodies at time ${short(frame.time)}, phase ${frame.phase_name}`);
    this.show_rings(camera);
    this.show_scale_bar(camera);
    this.show_legend(camera);
  }

  async paint_pixels(png) {
    const image = await createImageBitmap(new Blob([png], {type: "image/png"}));
    this.canvas.getContext("2d").drawImage(image, 0, 0, this.canvas.width, this.canvas.height);
  }

  // Rings and arrow are in pixels of the page.
  show_rings(camera) {
    const ratio = this.canvas.width / by_id("view").clientWidth, {disks, picked} = this.frame;
    const ring = (circle, body) => {
      circle.toggleAttribute("hidden", body === null || !disks || 3 * body >= disks.length);
      if (circle.hasAttribute("hidden")) return;
      const [x, y] = camera.to_pixel([disks[3 * body], disks[3 * body + 1]]);
      const reach = this.frame.shapes?.find((shape) => shape.body === body)?.reach ?? disks[3 * body + 2];
      for (const [name, value] of [["cx", x], ["cy", y], ["r", reach * camera.scale + 2.5]])
        circle.setAttribute(name, value / ratio);
    };
    ring(by_id("ring"), picked);
    ring(by_id("hover_ring"), this.hovered);
    const arrow = by_id("arrow"), {held} = this;
    arrow.toggleAttribute("hidden", !held || !disks);
    if (!held || !disks) return;
    const from = camera.to_pixel([disks[3 * held.body], disks[3 * held.body + 1]]);
    ["x1", "y1"].forEach((name, i) => arrow.setAttribute(name, from[i] / ratio));
    ["x2", "y2"].forEach((name, i) => arrow.setAttribute(name, held.to[i] / ratio));
  }

  show_scale_bar(camera) {
    const bar = by_id("scale_bar"), ratio = this.canvas.width / by_id("view").clientWidth;
    bar.hidden = !this.frame.shows?.scale_bar;
    if (bar.hidden) return;
    const size = nice_below((0.2 * camera.width) / camera.scale);
    const {metres} = this.frame;
    bar.firstElementChild.textContent = `${short(size)} d${metres ? ` = ${si(size * metres, "m")}` : ""}`;
    bar.lastElementChild.style.width = `${(size * camera.scale) / ratio}px`;
  }

  // What is drawn besides the colours of the grains, each with the class of its sign and what it means.
  drawn(camera) {
    const {palette, intruders, bonds, broken, force_scale, disks, applied, shapes = []} = this.frame;
    if (!disks) return [];
    // Smaller bodies show no arrow.
    const arrowed = (reach) => reach * camera.scale >= 7;
    const force = force_scale ? `${short(force_scale)} F_g` : "";
    return [
      intruders.length ? ["", palette.intruder, "intruder"] : null,
      bonds.length ? ["line", force ? palette.faint_ink : palette.ink, "active bond"] : null,
      force ? ["line", palette.compressive, `compression, 0.4 d wide: ${force}`] : null,
      force ? ["line", palette.tensile, "tension"] : null,
      broken.length && draws_bars(camera) ? ["bar", palette.broken, "broken bond, still near"] : null,
      shows_sides(this.frame, camera) ? ["side", palette.faint_ink, "periodic side, pale images"] : null,
      shapes.some(({reach, force}) => arrowed(reach) && Math.hypot(...force) > 0) ? ["arrow up", palette.ink, "reaction on the intruder"] : null,
      applied.some(([k]) => arrowed(disks[3 * k + 2]) && !shapes.some(({body}) => body === k)) ? ["arrow", palette.ink, "applied force"] : null,
    ].filter(Boolean);
  }

  show_legend(camera) {
    const part = by_id("legend"), {legend, shows} = this.frame, drawn = this.drawn(camera);
    const text = JSON.stringify([legend, shows, drawn]);
    if (part.dataset.made === text) return;
    part.dataset.made = text;
    part.replaceChildren();
    if (!legend || !shows.legend) return;
    // Italics and subscripts are between marks.
    const title = element("div", {});
    legend.title.split(/(\x01[^\x01]*\x01|\x02[^\x02]*\x02)/).forEach((piece) => {
      const kind = {"\x01": "em", "\x02": "sub"}[piece[0]];
      title.append(kind ? element(kind, {}, piece.slice(1, -1)) : piece);
    });
    part.append(title);
    if (legend.bar) {
      const bar = element("div", {className: "bar"});
      bar.style.background = `linear-gradient(to right, ${legend.bar.map(css).join()})`;
      part.append(bar, element("div", {className: "ends"}, ...legend.range.map((x) => element("span", {}, short(x)))));
    }
    const list = (signs, className) => element("ul", {className}, ...signs.map(([kind, colour, label]) => {
      const sign = element("i", {className: kind});
      sign.style.setProperty("--sign", css(colour));
      return element("li", {}, sign, element("span", {}, ...typeset(label)));
    }));
    if (legend.swatches.length) part.append(list(legend.swatches.map((swatch) => ["", ...swatch]), "colours"));
    if (drawn.length) part.append(list(drawn, "signs"));
  }

  // What the gestures ask for.
  look(window) {
    this.own = window;
    this.looking = true;
    this.redraw();
    clearTimeout(this.resting);
    const soon = this.frame.png ? 30 : kCameraRests;
    this.resting = setTimeout(() => {
      const [left, low, right, high] = this.camera().window;
      this.controls.tried("camera", {low: [left, low], high: [right, high]}).then(() => (this.looking = false));
    }, soon);
  }

  fit(what) {
    clearTimeout(this.resting);
    this.controls.tried("camera", {fit: what}).then(() => (this.own = null));
    this.own = null;
  }

  body_at(pixel) {
    const [x, y] = this.camera().to_world(pixel), {disks, box, shapes = []} = this.frame;
    if (!disks) return -1;
    const shaped = new Map(shapes.map((shape) => [shape.body, shape.parts]));
    for (let at = 0; at < disks.length; at += 3) {
      let dx = x - disks[at];
      if (box.periodic) dx -= box.width * Math.round(dx / box.width);
      const dy = y - disks[at + 1], parts = shaped.get(at / 3) ?? [{corners: [[0, 0]], radius: disks[at + 2]}];
      if (parts.some((part) => holds(part, dx, dy))) return at / 3;
    }
    return -1;
  }

  async point(pixel) {
    this.pointed = pixel;
    if (this.pointing) return;
    this.pointing = true;
    try {
      const body = pixel ? this.body_at(pixel) : -1;
      this.hovered = body < 0 ? null : body;
      const found = body < 0 ? null : await this.connection.ask("body", {at: this.camera().to_world(pixel)});
      this.show_tooltip(pixel, found && found.body !== null ? found : null);
      this.redraw();
    } catch {
      this.show_tooltip(null, null);
    } finally {
      this.pointing = false;
    }
    if (this.pointed !== pixel) this.point(this.pointed);
  }

  show_tooltip(pixel, body) {
    const tooltip = by_id("tooltip");
    tooltip.hidden = !body;
    if (!body) return;
    show_tooltip(tooltip, body);
    const view = by_id("view"), ratio = this.canvas.width / view.clientWidth, [x, y] = pixel.map((p) => p / ratio);
    tooltip.style.left = `${Math.max(0, Math.min(x + 16, view.clientWidth - tooltip.offsetWidth - 4))}px`;
    tooltip.style.top = `${Math.max(0, y + 16 + tooltip.offsetHeight > view.clientHeight ? y - tooltip.offsetHeight - 10 : y + 16)}px`;
  }

  async pick(pixel) {
    const at = this.camera().to_world(pixel);
    await this.controls.tried("pick", {at});
    const body = await this.connection.ask("body", {at});
    if (body.body === null) return;
    by_id("d_inspect").open = true;
    show_inspection(by_id("inspection"), body);
  }

  grip(pixel) {
    const body = this.body_at(pixel);
    return body < 0 ? null : {body, from: this.camera().to_world(pixel)};
  }

  pull({body, from}, pixel) {
    const to = this.camera().to_world(pixel), force = [0, 1].map((i) => this.frame.pull * (to[i] - from[i]));
    this.held = {body, to: pixel};
    this.held_force = force;
    this.redraw();
    if (this.pulling) return;
    this.pulling = this.controls.tried("apply", {body, force}).then(() => {
      this.pulling = null;
      if (this.held && this.held_force !== force) this.pull({body, from}, this.held.to);
    });
  }

  let_go({body}) {
    this.held = null;
    this.controls.tried("apply", {body, force: [0, 0]});
    this.redraw();
  }

  run_or_pause() {
    const {timeline} = this.frame;
    if (timeline) return this.controls.tried("play", {on: !timeline.playing});
    this.controls.tried(this.frame.running ? "pause" : "start");
  }
  step() { this.frame.timeline ? this.controls.tried("show", {by: 1}) : this.controls.tried("run", {steps: 1}); }
  toggle_pull() {
    this.gestures.pull_mode = !this.gestures.pull_mode;
    this.canvas.classList.toggle("pulls", this.gestures.pull_mode);
    document.querySelector("#camera [data-do=pull]").setAttribute("aria-pressed", this.gestures.pull_mode);
  }
}

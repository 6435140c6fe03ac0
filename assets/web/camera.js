// Where the world lies in the picture, and how mouse, wheel, fingers and keys move it.
import {hatch_depth, text_size} from "./drawing.js";

const kZoomOfANotch = 1.1, kZoomOfAKey = 1.25, kLeastDrag = 4;

// Room around the world for what is drawn behind walls [px].
function margins_of(frame, width, height) {
  const room = {left: 2, top: 2, right: 2, bottom: 2}, depth = hatch_depth(text_size(width, height)) + 1;
  for (const [, , nx, ny] of frame.walls) {
    if (nx > 0.5) room.left = Math.max(room.left, depth);
    if (nx < -0.5) room.right = Math.max(room.right, depth);
    if (ny > 0.5) room.bottom = Math.max(room.bottom, depth);
    if (ny < -0.5) room.top = Math.max(room.top, depth);
  }
  return room;
}

// The box or the bodies with a little room.
function with_margins([left, low, right, high], {width, periodic, floor}) {
  if (width > 0) {
    const side = periodic ? 1 : 0;
    return [left - side, low, right + side, high];
  }
  const more = 0.04 * Math.max(right - left, high - low);
  return [left - more, floor ? low : low - more, right + more, high + more];
}

export class Camera {
  // The window as large as possible in the picture, and then all that there is room for beside it.
  constructor(frame, window, width, height) {
    const room = margins_of(frame, width, height);
    const inner = [Math.max(1, width - room.left - room.right), Math.max(1, height - room.top - room.bottom)];
    const [left, low, right, high] = window;
    this.scale = Math.min(inner[0] / (right - left), inner[1] / (high - low));
    const half = [inner[0] / this.scale / 2, inner[1] / this.scale / 2], centre = [(left + right) / 2, (low + high) / 2];
    this.window = [centre[0] - half[0], centre[1] - half[1], centre[0] + half[0], centre[1] + half[1]];
    this.origin = [room.left - this.scale * this.window[0], room.top + this.scale * this.window[3]];
    this.clip = [0, 0, width, height];
    Object.assign(this, {width, height});
  }
  to_pixel([x, y]) { return [this.origin[0] + this.scale * x, this.origin[1] - this.scale * y]; }
  to_world([x, y]) { return [(x - this.origin[0]) / this.scale, (this.origin[1] - y) / this.scale]; }
}

export function first_window(frame) { return frame.fitted ? with_margins(frame.window, frame.box) : frame.window; }

// Moves and zooms a window by the user's hand. `world` knows the present camera and the grains; it is told of a new
// window, of clicks, of places pointed at, and of grains that are pulled.
export class Gestures {
  constructor(canvas, world) {
    Object.assign(this, {canvas, world, pointers: new Map(), pulling: null, moved: 0, pull_mode: false});
    const on = (name, act) => canvas.addEventListener(name, (event) => world.camera() && act(event));
    on("pointerdown", (e) => this.press(e));
    on("pointermove", (e) => this.move(e));
    on("pointerup", (e) => this.release(e));
    on("pointercancel", (e) => this.release(e));
    on("pointerleave", (e) => e.pointerType === "mouse" && world.point(null));
    on("dblclick", () => world.fit("box"));
    on("wheel", (e) => {
      e.preventDefault();
      const notches = e.deltaMode === 0 ? -e.deltaY / 100 : -e.deltaY / 3;
      this.zoom(kZoomOfANotch ** Math.max(-8, Math.min(8, notches)), this.pixel(e));
    });
    canvas.addEventListener("keydown", (e) => world.camera() && this.key(e));
  }

  // Of the picture, which may have more pixels than the page.
  pixel(event) {
    const rect = this.canvas.getBoundingClientRect(), ratio = this.canvas.width / rect.width;
    return [(event.clientX - rect.left) * ratio, (event.clientY - rect.top) * ratio];
  }

  zoom(factor, pixel) {
    const camera = this.world.camera(), [x, y] = pixel ? camera.to_world(pixel) : this.middle(), w = camera.window;
    const size = Math.min(w[2] - w[0], w[3] - w[1]) / factor;
    if (size < 1e-2 || size > 1e6) return;
    this.world.look([x + (w[0] - x) / factor, y + (w[1] - y) / factor, x + (w[2] - x) / factor, y + (w[3] - y) / factor]);
  }

  middle() {
    const w = this.world.camera().window;
    return [(w[0] + w[2]) / 2, (w[1] + w[3]) / 2];
  }

  pan(dx, dy) {
    const {window: w, scale} = this.world.camera();
    this.world.look([w[0] - dx / scale, w[1] + dy / scale, w[2] - dx / scale, w[3] + dy / scale]);
  }

  press(event) {
    this.canvas.setPointerCapture(event.pointerId);
    const pixel = this.pixel(event);
    this.pointers.set(event.pointerId, pixel);
    this.moved = 0;
    const pulls = event.button === 0 && this.pull_mode !== (event.ctrlKey || event.altKey);
    if (this.pointers.size === 1 && pulls) this.pulling = this.world.grip(pixel);
  }

  move(event) {
    const pixel = this.pixel(event), before = this.pointers.get(event.pointerId);
    if (!before) return this.world.point(pixel);
    if (this.pointers.size === 2) this.pinch(event.pointerId, pixel);
    this.pointers.set(event.pointerId, pixel);
    if (this.pointers.size > 1) return;
    const [dx, dy] = [pixel[0] - before[0], pixel[1] - before[1]];
    this.moved += Math.hypot(dx, dy);
    if (this.pulling !== null) return this.world.pull(this.pulling, pixel);
    if (this.moved > kLeastDrag) this.pan(dx, dy);
  }

  pinch(id, pixel) {
    const before = this.pointers.get(id), [[, other]] = [...this.pointers].filter(([key]) => key !== id);
    const apart = (p) => Math.max(1, Math.hypot(p[0] - other[0], p[1] - other[1]));
    this.moved = 2 * kLeastDrag;
    this.pan((pixel[0] - before[0]) / 2, (pixel[1] - before[1]) / 2);
    this.zoom(apart(pixel) / apart(before), [(pixel[0] + other[0]) / 2, (pixel[1] + other[1]) / 2]);
  }

  release(event) {
    const pixel = this.pointers.get(event.pointerId);
    this.pointers.delete(event.pointerId);
    if (!pixel) return;
    if (this.pulling !== null) this.world.let_go(this.pulling);
    this.pulling = null;
    if (this.moved <= kLeastDrag && event.type === "pointerup") this.world.pick(pixel);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = 0.1 * Math.min(this.canvas.width, this.canvas.height);
    const acts = {
      ArrowLeft: () => this.pan(step, 0), ArrowRight: () => this.pan(-step, 0),
      ArrowUp: () => this.pan(0, step), ArrowDown: () => this.pan(0, -step),
      "+": () => this.zoom(kZoomOfAKey), "=": () => this.zoom(kZoomOfAKey), "-": () => this.zoom(1 / kZoomOfAKey),
      0: () => this.world.fit("box"), " ": () => this.world.run_or_pause(), s: () => this.world.step(),
      p: () => this.world.toggle_pull(), Enter: () => this.world.pick(this.world.camera().to_pixel(this.middle())),
    };
    const act = acts[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }
}

export {kZoomOfAKey};

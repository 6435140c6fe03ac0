// From a frame of the server to disks and segments in pixels: what render/layers does for the program's own pictures.
import {DrawList, packed} from "./painter.js";

const clamp = (x, low, high) => Math.min(Math.max(x, low), high);

// Opacity is rounded to bytes as colours are.
const brightness = ([r, g, b]) => (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255;
// The one of two that stands out more on a ground.
const clearer_on = (ground, one, other) => {
  const apart = (c) => Math.abs(brightness(c) - brightness(ground));
  return apart(one) >= apart(other) ? one : other;
};
const with_alpha = ([r, g, b], alpha) => [r, g, b, Math.round(255 * alpha)];

export function text_size(width, height) { return clamp(Math.round(9 + Math.min(width, height) / 120), 10, 40); }
// Bars of broken bonds would blend with the colours of smaller grains.
export function draws_bars(camera) { return camera.scale >= 8; }
// Whether a periodic side is in sight.
export function shows_sides(frame, {window}) {
  const {periodic, width} = frame.box;
  return periodic && [0, width].some((x) => x >= window[0] && x <= window[2]);
}
export function hatch_depth(text) { return Math.round(0.55 * text); }

class Drawing {
  constructor(frame, camera) {
    Object.assign(this, {frame, camera, palette: frame.palette});
    this.shapes = frame.shapes ?? [];
    this.list = new DrawList(camera.width, camera.height, frame.palette.background);
    this.colour = Object.fromEntries(Object.entries(frame.palette).map(([name, value]) => [name, packed(value)]));
    this.text = text_size(camera.width, camera.height);
  }

  sees(x, y, reach) {
    const [left, top, width, height] = this.camera.clip;
    return x + reach > left && x - reach < left + width && y + reach > top && y - reach < top + height;
  }

  // Calls draw(shift) for each place where something between two abscissas appears.
  at_each_image(low, high, draw) {
    draw(0);
    const {periodic, width} = this.frame.box;
    if (!periodic) return;
    if (low < 0) draw(width);
    if (high > width) draw(-width);
  }

  each_disk(draw) {
    const {disks} = this.frame, {scale, origin} = this.camera;
    const shaped = new Set(this.shapes.map((shape) => shape.body));
    for (let k = 0, at = 0; at < disks.length; ++k, at += 3) {
      if (shaped.has(k)) continue;
      const x = disks[at], y = disks[at + 1], r = disks[at + 2];
      this.at_each_image(x - r, x + r, (shift) => {
        const px = origin[0] + scale * (x + shift), py = origin[1] - scale * y;
        if (this.sees(px, py, r * scale)) draw(k, px, py, r * scale);
      });
    }
  }

  disks() {
    const {frame, palette, colour} = this;
    const forces = Boolean(frame.force_scale);
    const paling = forces ? (frame.theme === "light" ? 0.62 : 0.45) : 0;
    const outline = packed(with_alpha(palette.outline, (palette.outline[3] / 255) * (1 - paling)));
    const fills = [];
    for (let i = 0; i < frame.colours.length; i += 3) fills.push(frame.colours.subarray(i, i + 3));
    const packed_fills = fills.map(packed);
    const intruders = new Set(frame.intruders);
    this.each_disk((k, x, y, r) => {
      if (intruders.has(k)) {
        this.list.disk(x, y, r, colour.intruder, clamp(0.1 * r, 1, 3), colour.intruder_outline);
      } else {
        this.list.disk(x, y, r, packed_fills[frame.colour[k]], r < 2.2 ? 0 : clamp(0.13 * r, 0.5, 1.6), outline);
      }
    });
  }

  // On the disks, over what passes between them.
  marks() {
    const {frame, palette} = this;
    const intruders = new Set(frame.intruders), applied = new Map(frame.applied.map(([k, ...force]) => [k, force]));
    if (!applied.size && !frame.angle) return;
    const fill = (k) => (intruders.has(k) ? palette.intruder : frame.colours.subarray(3 * frame.colour[k], 3 * frame.colour[k] + 3));
    this.each_disk((k, x, y, r) => {
      const force = applied.get(k);
      if (force) this.applied_force(x, y, r, force, packed(clearer_on(fill(k), palette.ink, palette.background)));
      if (frame.angle && r >= 4) this.orientation(x, y, r, frame.angle[k], intruders.has(k));
    });
  }

  // Bodies of several parts: the outline of the union is all parts in its colour, then all a little narrower in their own.
  shaped_bodies() {
    const {disks} = this.frame, {scale, origin} = this.camera;
    for (const {body, angle, reach, radius, force, parts} of this.shapes) {
      const x = disks[3 * body], y = disks[3 * body + 1];
      this.at_each_image(x - reach, x + reach, (shift) => {
        const px = origin[0] + scale * (x + shift), py = origin[1] - scale * y, size = reach * scale;
        if (!this.sees(px, py, size)) return;
        for (const [inset, colour] of [[0, this.colour.intruder_outline], [clamp(0.1 * radius * scale, 0.7, 2), this.colour.intruder]])
          for (const part of parts)
            this.part(part.corners.map(([cx, cy]) => [px + scale * cx, py - scale * cy]),
                      Math.max(0.5, part.radius * scale - inset), colour);
        if (this.frame.shows.orientation)
          this.list.line(px, py, px + 0.4 * size * Math.cos(angle), py - 0.4 * size * Math.sin(angle),
                         clamp(0.04 * size, 0.8, 3), this.colour.background, true);
        this.reaction(px, py, size, force);
      });
    }
  }

  part(corners, radius, colour) {
    if (corners.length === 1) return this.list.disk(...corners[0], radius, colour, 0, 0);
    if (corners.length > 2) this.fill_polygon(corners, colour);
    for (let k = 0; k < (corners.length === 2 ? 1 : corners.length); ++k)
      this.list.line(...corners[k], ...corners[(k + 1) % corners.length], 2 * radius, colour, true);
  }

  // What can be seen of it, in strips that overlap by half, drawn in from the edges, which the rounding covers.
  fill_polygon(corners, colour) {
    const heights = corners.map((corner) => corner[1]), low = Math.min(...heights), high = Math.max(...heights);
    const [clip_left, clip_top, clip_width, clip_height] = this.camera.clip;
    const first = low + 0.5 + Math.max(0, Math.floor(clip_top - 2 - low));
    for (let y = first, end = Math.min(high, clip_top + clip_height + 2); y < end; ++y) {
      let left = Infinity, right = -Infinity;
      corners.forEach((p, k) => {
        const q = corners[(k + 1) % corners.length];
        if (p[1] < y === q[1] < y) return;
        const x = p[0] + ((y - p[1]) / (q[1] - p[1])) * (q[0] - p[0]);
        left = Math.min(left, x), right = Math.max(right, x);
      });
      left = Math.max(left, clip_left - 2), right = Math.min(right, clip_left + clip_width + 2);
      if (right - left > 1) this.list.line(left + 0.5, y, right - 0.5, y, 2, colour);
    }
  }

  // An arrow whose length says nothing, with a rim that sets it off from the body.
  reaction(x, y, reach, [fx, fy]) {
    const size = Math.hypot(fx, fy);
    if (size === 0 || reach < 7) return;
    const along = [fx / size, -fy / size], across = [-along[1], along[0]];
    const width = clamp(0.05 * reach, 1.2, 4), length = 0.8 * reach;
    const tip = [x + length * along[0], y + length * along[1]];
    for (const [wide, colour] of [[width + 3, this.colour.background], [width, this.colour.compressive]]) {
      this.list.line(x, y, ...tip, wide, colour, true);
      for (const side of [-0.7, 0.7])
        this.list.line(...tip, tip[0] - 0.22 * length * (along[0] + side * across[0]),
                       tip[1] - 0.22 * length * (along[1] + side * across[1]), wide, colour, true);
    }
  }

  applied_force(x, y, r, [fx, fy], ink) {
    const size = Math.hypot(fx, fy);
    if (r < 7 || size === 0) return;
    const along = [fx / size, -fy / size], across = [-along[1], along[0]];
    const width = Math.max(1.2, 0.13 * r), tip = [x + 0.58 * r * along[0], y + 0.58 * r * along[1]];
    this.list.line(x - 0.55 * r * along[0], y - 0.55 * r * along[1], ...tip, width, ink, true);
    for (const side of [-0.8, 0.8])
      this.list.line(...tip, tip[0] - 0.42 * r * (along[0] + side * across[0]),
                     tip[1] - 0.42 * r * (along[1] + side * across[1]), width, ink, true);
  }

  orientation(x, y, r, angle, intruder) {
    const axis = [Math.cos(angle), -Math.sin(angle)], inner = (intruder ? 0.68 : 0.3) * r, outer = 0.82 * r;
    this.list.line(x + inner * axis[0], y + inner * axis[1], x + outer * axis[0], y + outer * axis[1],
                   clamp(0.16 * r, 0.8, 3), intruder ? this.colour.background : packed(with_alpha(this.palette.ink, 0.75)), true);
  }

  // Of a pair of a shaped body what the server says: start and vector of a line, middle of the gap, normal, smaller radius.
  touch(a) {
    const k = a - this.frame.disks.length / 3;
    return k < 0 ? null : this.frame.touches.subarray(9 * k, 9 * k + 9);
  }

  // Centre of a, and vector to the centre of b or to the surface of a wall.
  link(a, b) {
    const touch = this.touch(a);
    if (touch) return touch;
    const {disks, box, walls} = this.frame, x = disks[3 * a], y = disks[3 * a + 1];
    if (b < 0) {
      const [wx, wy, nx, ny] = walls[-1 - b], distance = nx * (x - wx) + ny * (y - wy);
      return [x, y, -nx * distance, -ny * distance];
    }
    let dx = disks[3 * b] - x;
    if (box.periodic && Math.abs(dx) > box.width / 2) dx -= box.width * Math.round(dx / box.width);
    return [x, y, dx, disks[3 * b + 1] - y];
  }

  draw_link([x, y, dx, dy], draw) {
    const {scale, origin} = this.camera;
    this.at_each_image(Math.min(x, x + dx), Math.max(x, x + dx), (shift) => {
      const x0 = origin[0] + scale * (x + shift), y0 = origin[1] - scale * y;
      const x1 = x0 + scale * dx, y1 = y0 - scale * dy;
      if (this.sees((x0 + x1) / 2, (y0 + y1) / 2, Math.hypot(x1 - x0, y1 - y0) / 2 + scale)) draw(x0, y0, x1, y1);
    });
  }

  bonds() {
    const width = clamp(0.14 * this.camera.scale, 0.7, 5), {bonds} = this.frame;
    const ink = this.frame.force_scale ? this.colour.faint_ink : this.colour.ink;
    for (let i = 0; i < bonds.length; i += 2)
      this.draw_link(this.link(bonds[i], bonds[i + 1]), (...ends) => this.list.line(...ends, width, ink, true));
  }

  forces() {
    const {force_pairs: pairs, forces, force_scale} = this.frame, {scale} = this.camera;
    if (!pairs) return;
    for (const tensile of [false, true]) {
      for (let i = 0; i < forces.length; ++i) {
        const width = Math.min((Math.abs(forces[i]) * 0.4 * scale) / force_scale, 1.2 * scale);
        if (forces[i] < 0 !== tensile || !(width >= 0.35)) continue;
        this.draw_link(this.link(pairs[2 * i], pairs[2 * i + 1]), (...ends) =>
          this.list.line(...ends, width, tensile ? this.colour.tensile : this.colour.compressive, true));
      }
    }
  }

  broken_bonds() {
    if (!draws_bars(this.camera)) return;
    const {broken} = this.frame, width = Math.min(0.2 * this.camera.scale, 8);
    const rim = packed(with_alpha(this.palette.background, 0.85));
    for (let i = 0; i < broken.length; i += 2) {
      const [mx, my, nx, ny, size] = this.touch(broken[i])?.subarray(4) ?? this.gap_of(broken[i], broken[i + 1]);
      const half = 0.62 * size;
      this.draw_link([mx + half * ny, my - half * nx, -2 * half * ny, 2 * half * nx], (...ends) => {
        this.list.line(...ends, 1.6 * width, rim, true);
        this.list.line(...ends, width, this.colour.broken, true);
      });
    }
  }

  // Middle of the gap between two disks, or a disk and a wall, the normal, and the smaller radius.
  gap_of(a, b) {
    const {disks} = this.frame, [x, y, dx, dy] = this.link(a, b);
    const apart = Math.hypot(dx, dy), nx = dx / apart, ny = dy / apart, r = disks[3 * a + 2];
    const other = b < 0 ? 0 : disks[3 * b + 2], middle = r + (apart - r - other) / 2;
    return [x + middle * nx, y + middle * ny, nx, ny, b < 0 ? r : Math.min(r, other)];
  }

  // Part of the picture between periodic sides.
  inside_the_sides() {
    const {clip, origin, scale} = this.camera, {periodic, width} = this.frame.box;
    if (!periodic) return clip;
    const left = Math.max(clip[0], Math.round(origin[0]));
    const right = Math.min(clip[0] + clip[2], Math.round(origin[0] + scale * width));
    return [left, clip[1], right - left, clip[3]];
  }

  periodic_sides() {
    const {box} = this.frame, {clip, origin, scale, window} = this.camera;
    if (!box.periodic) return;
    const top = clip[1], right = clip[0] + clip[2];
    const bottom = box.floor ? Math.min(clip[1] + clip[3], origin[1]) : clip[1] + clip[3];
    const pale = packed(with_alpha(this.palette.background, 0.55));
    for (const x of [0, box.width]) {
      if (x < window[0] || x > window[2] || bottom <= top) continue;
      const at = Math.round(origin[0] + scale * x), [from, to] = x === 0 ? [clip[0], at] : [at, right];
      const middle = (top + bottom) / 2;
      this.list.line(from, middle, to, middle, bottom - top, pale);
      const centre = x === 0 ? at - 0.5 : at + 0.5;
      this.dashed_line([centre, top], [centre, bottom], 1, 4, this.colour.faint_ink);
    }
  }

  dashed_line(from, to, width, dash, colour) {
    const dashes = Math.max(1, Math.round((Math.hypot(to[0] - from[0], to[1] - from[1]) / dash + 1) / 2));
    const step = [0, 1].map((i) => (to[i] - from[i]) / (2 * dashes - 1));
    for (let i = 0; i < dashes; ++i) {
      const start = [from[0] + 2 * i * step[0], from[1] + 2 * i * step[1]];
      this.list.line(...start, start[0] + step[0], start[1] + step[1], width, colour);
    }
  }

  walls() {
    const depth = hatch_depth(this.text), line = Math.max(1, Math.round(this.text / 9)), {scale} = this.camera;
    for (const wall of this.frame.walls) {
      const ends = this.visible_surface(wall);
      if (!ends) continue;
      const [, , nx, ny, piston] = wall, behind = [-nx, ny];
      const [from, to] = ends.map((p) => this.camera.to_pixel(p));
      const size = Math.hypot(to[0] - from[0], to[1] - from[1]), along = [(to[0] - from[0]) / size, (to[1] - from[1]) / size];
      const moved = ([x, y], by) => [x + by * behind[0], y + by * behind[1]];
      if (piston) {
        const plate = Math.max(depth, 0.6 * scale);
        this.list.line(...moved(from, plate / 2), ...moved(to, plate / 2), plate, this.colour.wall_body);
      } else {
        const spacing = 0.85 * depth, strokes = Math.floor((size + 1e-6) / spacing), reach = depth - line;
        for (let i = 1; i <= strokes; ++i) {
          const top = moved([from[0] + i * spacing * along[0], from[1] + i * spacing * along[1]], line / 2);
          this.list.line(...top, top[0] + reach * (behind[0] - along[0]), top[1] + reach * (behind[1] - along[1]),
                         line * 0.75, this.colour.wall);
        }
      }
      this.list.line(...moved(from, line / 2), ...moved(to, line / 2), line, this.colour.wall);
    }
  }

  // Its ends in the world, from left to right seen from the free side; null if nothing of it is seen.
  visible_surface(wall) {
    const [x, y, nx, ny] = wall, along = [ny, -nx], [left, low, right, high] = this.camera.window;
    const middle = [(left + right) / 2, (low + high) / 2];
    const t = along[0] * (middle[0] - x) + along[1] * (middle[1] - y), foot = [x + t * along[0], y + t * along[1]];
    const far = 2 * Math.hypot(right - left, high - low) + Math.hypot(middle[0] - x, middle[1] - y);
    let ends = [[foot[0] - far * along[0], foot[1] - far * along[1]], [foot[0] + far * along[0], foot[1] + far * along[1]]];
    const planes = [[left, low, 1, 0], [left, low, 0, 1], [right, high, -1, 0], [right, high, 0, -1]];
    for (const other of this.frame.walls)
      if (other !== wall && !other[4] && Math.abs(other[2] * nx + other[3] * ny) <= 0.999) planes.push(other);
    const rounding = 1e-9 * far;  // a surface along the edge of the window is in sight
    for (const [px, py, mx, my] of planes) {
      const [a, b] = ends.map(([ex, ey]) => mx * (ex - px) + my * (ey - py));
      if (a < -rounding && b < -rounding) return null;
      if (Math.min(a, b) >= -rounding) continue;
      const [p, q] = ends, s = a / (a - b), cut = [p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])];
      if (a < 0) ends = [cut, q];
      if (b < 0) ends = [p, cut];
    }
    return Math.hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]) > 1e-9 ? ends : null;
  }
}

export function draw(frame, camera) {
  const drawing = new Drawing(frame, camera);
  const {list} = drawing;
  list.clip_to(camera.clip);
  drawing.disks();
  drawing.shaped_bodies();
  list.clip_to(drawing.inside_the_sides());
  drawing.bonds();
  if (frame.force_scale) drawing.forces();
  list.clip_to(camera.clip);
  drawing.marks();
  list.clip_to(drawing.inside_the_sides());
  drawing.broken_bonds();
  list.clip_to(camera.clip);
  drawing.periodic_sides();
  drawing.walls();
  return list;
}

// Paints a list of disks and segments with WebGL 2, by the shaders that paint the program's own pictures.

const kDiskBytes = 24, kSegmentBytes = 28;
const kForms = {
  disks: {stride: kDiskBytes, attributes: [[4, "FLOAT", 0], [4, "UNSIGNED_BYTE", 16], [4, "UNSIGNED_BYTE", 20]]},
  segments: {stride: kSegmentBytes, attributes: [[4, "FLOAT", 0], [2, "FLOAT", 16], [4, "UNSIGNED_BYTE", 24]]},
};

// Shapes of one kind, as they lie in the memory of the GL.
class Shapes {
  constructor(words) {
    this.words = words;
    this.count = 0;
    this.grow(1024);
  }
  grow(capacity) {
    const buffer = new ArrayBuffer(4 * this.words * capacity);
    const numbers = new Float32Array(buffer), colours = new Uint32Array(buffer);
    if (this.colours) colours.set(this.colours);
    [this.numbers, this.colours, this.capacity] = [numbers, colours, capacity];
  }
  add() {
    if (this.count === this.capacity) this.grow(2 * this.capacity);
    return this.words * this.count++;
  }
}

// Colours are whole numbers, red in the lowest byte.
export function packed([r, g, b, a = 255]) { return (r | (g << 8) | (b << 16) | (a << 24)) >>> 0; }

// In pixels from the top left corner; painted in the order in which they were added.
export class DrawList {
  constructor(width, height, background) {
    Object.assign(this, {width, height, background});
    this.disks = new Shapes(kDiskBytes / 4);
    this.segments = new Shapes(kSegmentBytes / 4);
    this.batches = [];
    this.clip = [0, 0, width, height];
  }
  clip_to(rect) { this.clip = rect; }
  count(kind) {
    const last = this.batches.at(-1);
    if (last && last.kind === kind && last.clip === this.clip) return void ++last.count;
    this.batches.push({kind, first: this[kind].count - 1, count: 1, clip: this.clip});
  }
  disk(x, y, radius, fill, outline_width, outline) {
    const s = this.disks, at = s.add();
    s.numbers[at] = x;
    s.numbers[at + 1] = y;
    s.numbers[at + 2] = radius;
    s.numbers[at + 3] = outline_width;
    s.colours[at + 4] = fill;
    s.colours[at + 5] = outline;
    this.count("disks");
  }
  line(x0, y0, x1, y1, width, colour, round = false) {
    const s = this.segments, at = s.add();
    s.numbers[at] = x0;
    s.numbers[at + 1] = y0;
    s.numbers[at + 2] = x1;
    s.numbers[at + 3] = y1;
    s.numbers[at + 4] = width;
    s.numbers[at + 5] = round ? 1 : 0;
    s.colours[at + 6] = colour;
    this.count("segments");
  }
}

const kHead = "#version 300 es\nprecision highp float;\n";
const of_browsers = (text) => text.replace(/^#version.*\n/, kHead);

export class Painter {
  // Throws an error if the browser has no WebGL 2.
  constructor(canvas, shaders) {
    this.canvas = canvas;
    const gl = canvas.getContext("webgl2", {alpha: false, antialias: false, depth: false, preserveDrawingBuffer: true});
    if (!gl) throw new Error("This browser has no WebGL 2; start `quicksand serve --pixels`.");
    this.gl = gl;
    gl.enable(gl.BLEND);
    gl.enable(gl.SCISSOR_TEST);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    const make = (kind) => this.program(shaders.vertex_head + shaders[kind + "_vertex"], shaders[kind + "_fragment"]);
    this.programs = {disks: make("disk"), segments: make("segment")};
  }

  program(vertex, fragment) {
    const gl = this.gl, id = gl.createProgram();
    for (const [stage, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(stage);
      gl.shaderSource(shader, of_browsers(text));
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(id, shader);
    }
    gl.linkProgram(id);
    return {id, picture: gl.getUniformLocation(id, "picture"), array: gl.createVertexArray(), buffer: gl.createBuffer()};
  }

  paint(list) {
    const gl = this.gl;
    gl.viewport(0, 0, list.width, list.height);
    gl.scissor(0, 0, list.width, list.height);
    const [r, g, b] = list.background;
    gl.clearColor(r / 255, g / 255, b / 255, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    for (const kind of ["disks", "segments"]) {
      const shapes = list[kind];
      gl.bindBuffer(gl.ARRAY_BUFFER, this.programs[kind].buffer);
      gl.bufferData(gl.ARRAY_BUFFER, shapes.numbers.subarray(0, shapes.words * shapes.count), gl.STREAM_DRAW);
    }
    for (const batch of list.batches) this.paint_batch(list, batch);
  }

  paint_batch(list, {kind, first, count, clip}) {
    const gl = this.gl, program = this.programs[kind], form = kForms[kind];
    gl.useProgram(program.id);
    gl.uniform2f(program.picture, list.width, list.height);
    gl.bindVertexArray(program.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, program.buffer);
    form.attributes.forEach(([size, type, offset], i) => {
      gl.enableVertexAttribArray(i);
      gl.vertexAttribPointer(i, size, gl[type], type !== "FLOAT", form.stride, first * form.stride + offset);
      gl.vertexAttribDivisor(i, 1);
    });
    const [x, y, width, height] = clip;
    const left = Math.floor(x), right = Math.ceil(x + width), top = Math.floor(y), bottom = Math.ceil(y + height);
    gl.scissor(left, list.height - bottom, Math.max(0, right - left), Math.max(0, bottom - top));
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
  }
}

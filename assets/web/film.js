// A run in one file: its frames are in the page, and nothing is asked of a server.
import {decode} from "./connection.js";
import {element, short} from "./numbers.js";
import {Picture} from "./picture.js";
import {Timeline} from "./timeline.js";

const by_id = (id) => document.getElementById(id);
const kPicturesASecond = 30;
const {frames, run, shaders} = JSON.parse(by_id("film").textContent);
const now = {sample: 0, samples: frames.length, playing: false, speed: 1, loop: false};
let frame = null, on_the_way = 0;

async function show(sample) {
  now.sample = Math.max(0, Math.min(frames.length - 1, sample));
  const bytes = Uint8Array.from(atob(frames[now.sample]), (letter) => letter.charCodeAt(0));
  frame = {...decode(bytes.buffer), timeline: {...now}};
  document.documentElement.dataset.theme = frame.theme;
  picture.show(frame);
  tell();
}

function tell() {
  frame.timeline = {...now};
  timeline.set_moment(frame);
  const readings = [["Time", `${frame.time.toFixed(3)} √(d/g)`], ["Phase", frame.phase_name], ["Bodies", frame.bodies]];
  if (frame.method) readings.push(["Method", frame.method]);
  by_id("status").replaceChildren(...readings.map(([name, value]) =>
    element("div", {}, element("dt", {}, name), element("dd", {}, String(value)))));
}

// The commands of the timeline; others have nothing to act on.
const commands = {
  async tried(name, values = {}) {
    if (name === "show") {
      const {sample, by, phase} = values;
      await show(sample ?? (by === undefined ? run.sample_phases.indexOf(phase) : now.sample + by));
    } else if (name === "play") {
      if (values.on && !now.playing && now.sample === frames.length - 1) await show(0);
      Object.assign(now, {playing: values.on, speed: values.speed ?? now.speed, loop: values.loop ?? now.loop});
      tell();
    }
    return null;
  },
};

function play_frame() {
  if (!now.playing) return;
  on_the_way += now.speed;
  const whole = Math.floor(on_the_way), last = frames.length - 1;
  on_the_way -= whole;
  if (whole === 0) return;
  if (now.sample < last) return void show(now.sample + whole);
  if (now.loop) return void show(0);
  now.playing = false;
  tell();
}

for (const part of [by_id("panel"), by_id("plots"), document.querySelector("[data-do=pull]")]) part.remove();
document.querySelector("main").classList.add("film");
const connection = {drawn() {}, ask: async () => ({body: null})};
const picture = new Picture(connection, shaders, commands);
const timeline = new Timeline(by_id("timeline"), commands);
timeline.go_on.remove();
by_id("timeline").hidden = false;
timeline.set_run(run);
await show(frames.length - 1);
document.title = `${frame.scene}, ${short(run.sample_times.at(-1))} √(d/g)`;
setInterval(play_frame, 1000 / kPicturesASecond);
// For those who look into the page, tests among them.
window.quicksand = {picture, timeline, frame: () => frame};

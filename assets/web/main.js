// Joins the parts of the page: the connection, the picture, the controls, the plots.
import {Connection} from "./connection.js";
import {number_in, show_actions, show_parameters, show_view} from "./controls.js";
import {capitalised, duration, element, grouped, short, si, typeset} from "./numbers.js";
import {Picture} from "./picture.js";
import {Plots} from "./plots.js";
import {Timeline} from "./timeline.js";

const by_id = (id) => document.getElementById(id);
const kMostMessages = 200;

// The cookie holds the token from now on; the address need not show it.
if (location.search) history.replaceState(null, "", location.pathname);

const root = document.documentElement;
const dark = matchMedia("(prefers-color-scheme: dark)");
root.dataset.theme = dark.matches ? "dark" : "light";
if (matchMedia("(max-width: 760px)").matches) for (const part of ["d_view", "d_parameters"]) by_id(part).open = false;

let state = null, frame = null;

function log(text, wrong = false) {
  const list = by_id("log");
  list.append(element("li", {className: wrong ? "wrong" : ""}, text));
  if (list.children.length > kMostMessages) list.firstElementChild.remove();
  list.scrollTop = list.scrollHeight;
}

function banner(text) {
  by_id("banner").hidden = !text;
  by_id("banner").firstElementChild.textContent = text;
}
by_id("banner").lastElementChild.addEventListener("click", () => banner(""));

// Commands of the controls: each is logged, and a refusal is shown.
const commands = {
  async command(name, values = {}) {
    const digits = (_, value) => (typeof value === "number" ? Number(value.toPrecision(6)) : value);
    const text = Object.keys(values).length ? `${name} ${JSON.stringify(values, digits)}` : name;
    try {
      const result = await connection.command(name, values);
      if (name !== "apply" && name !== "show" && !("width" in values)) log(text);
      return result;
    } catch (error) {
      log(`${text}: ${error.message}`, true);
      throw error;
    }
  },
  // What went wrong before no longer matters to who tries something else.
  tried(name, values) {
    banner("");
    return this.command(name, values).catch((error) => {
      banner(error.message);
      return null;
    });
  },
  refused(text) { banner(text); },
};

function chip(word, kind = "") {
  const part = by_id("chip");
  if (part.textContent !== word) part.textContent = word;
  part.className = kind;
}

let themed = false;
function show_state(message) {
  state = message;
  const select = by_id("scene");
  const names = state.scene && !state.scenes.includes(state.scene) ? [state.scene, ...state.scenes] : state.scenes;
  select.replaceChildren(...names.map((name) => element("option", {value: name}, name)));
  select.value = state.scene ?? "";
  if (!state.loaded) return;
  // A run that is walked through is not computed.
  for (const part of ["computing", "pace_row", "phases", "d_parameters", "d_actions"]) by_id(part).hidden = state.walks;
  for (const file of ["state", "film"]) by_id("files").querySelector(`[data-file=${file}]`).hidden = state.walks;
  by_id("description").textContent = state.description;
  if (document.activeElement !== by_id("pace")) by_id("pace").value = state.steps_per_frame;
  plots.set_phases(state.phases);
  if (frame) show_phases();
  by_id("undo").disabled = !state.last_change;
  by_id("undo").title = state.last_change ? `Undoes the change of ${state.last_change} (Ctrl+Z)` : "Nothing was changed";
  show_parameters(by_id("parameters"), state, commands);
  show_view(by_id("view_fields"), state, commands);
  // The first page that opens chooses the look; later it is a value like others.
  if (!themed && dark.matches && !state.theme_chosen) commands.tried("view", {theme: "dark"});
  themed = true;
}

function show_status() {
  const list = [
    ["Step", grouped(frame.step)],
    ["Time", `${frame.time.toFixed(3)} √(d/g)${frame.seconds ? ` = ${si(frame.time * frame.seconds, "s")}` : ""}`],
    ["Bodies", grouped(frame.bodies)],
    ["Steps/s", frame.steps_per_second && frame.running ? grouped(frame.steps_per_second) : "–"],
    ["Residual", short(frame.residual ?? null)],
  ];
  if (frame.critical_force) list.push(["Critical force", frame.critical_force]);
  if (frame.method) list.push(["Method", frame.method]);
  if (frame.unconverged > 0) list.push(["Not converged", `${grouped(frame.unconverged)} steps${frame.method ? ", by design" : ""}`]);
  const part = by_id("status");
  part.hidden = frame.shows?.numbers === false;
  while (part.children.length < list.length) part.append(element("div", {}, element("dt", {}), element("dd", {})));
  while (part.children.length > list.length) part.lastElementChild.remove();
  list.forEach(([name, value], i) => {
    part.children[i].firstElementChild.textContent = name;
    part.children[i].lastElementChild.replaceChildren(...typeset(value));
  });
}

function show_phases() {
  const part = by_id("phases"), names = state?.phases ?? [];
  const text = JSON.stringify([names, frame.phase]);
  if (part.dataset.made !== text) {
    part.dataset.made = text;
    part.replaceChildren(...names.map((name, i) => {
      const now = i === frame.phase && !frame.finished;
      const item = element("li", {className: now ? "now" : i < frame.phase ? "done" : ""}, element("span", {}, name));
      if (now) item.append(element("small", {}), element("progress", {max: 1, "aria-label": `Progress of ${name}`}));
      return item;
    }));
  }
  const now = part.querySelector(".now");
  if (!now) return;
  const left = frame.running && frame.seconds_left ? `, ${duration(frame.seconds_left)} left` : "";
  now.querySelector("small").textContent = `${Math.floor(100 * frame.progress)} %${left}`;
  now.querySelector("progress").value = frame.progress;
}

function show_frame(message) {
  frame = message;
  root.dataset.theme = frame.theme;
  picture.show(frame);
  show_status();
  show_phases();
  timeline.set_moment(frame);
  plots.set_moment(frame.timeline ? frame.time : null);
  if (frame.timeline) return chip(frame.timeline.playing ? "playing" : "a run", frame.timeline.playing ? "running" : "");
  const over = frame.finished || frame.failed;
  chip(frame.failed ? "stopped" : frame.finished ? "finished" : frame.running ? "running" : "paused",
       frame.failed ? "failed" : frame.finished ? "finished" : frame.running ? "running" : "");
  by_id("run").textContent = frame.running ? "Pause" : "Run";
  by_id("run").disabled = by_id("step").disabled = over;
  const film = by_id("files").querySelector("[data-file=film]");
  film.textContent = frame.recording ? "End film" : "Film";
  film.setAttribute("aria-pressed", frame.recording);
}

function heard(message) {
  if (message.kind === "frame") show_frame(message);
  else if (message.kind === "state") show_state(message);
  else if (message.kind === "plots") plots.show(message), timeline.set_run(message);
  else if (message.kind === "note") log(message.text);
  else if (message.ok === false) banner(message.error), log(message.error, true);
}

function changed(connected) {
  if (connected === "open") {
    banner("");
    return chip("connected");
  }
  chip("no connection", "lost");
  banner({
    lost: "The connection to the server was lost; trying again.",
    full: "As many pages as the server takes are connected; trying again.",
    refused: "The server was restarted with another token: open the address that it printed.",
  }[connected]);
}

// Fetches a file of the run's folder.
function download(file) {
  const link = element("a", {href: `files/${file}`, download: file.split("/").pop()});
  document.body.append(link);
  link.click();
  link.remove();
  log(`fetched ${file}`);
}

const kFiles = {
  state: ["State", "The current state, a checkpoint from which quicksand run continues", async () => (await commands.command("save", {file: "state.cbor"}), "state.cbor")],
  csv: ["CSV", "The time histories", async () => (await connection.ask("series")).file],
  png: ["PNG", "The picture as the program draws it", async () => (await commands.command("snapshot", {file: "picture.png", ...picture.size()}), "picture.png")],
  film: ["Film", "Records frames until it is pressed again, then downloads the film", async () => {
    if (!frame.recording) return void (await commands.command("record", {on: true, folder: "film"}));
    const result = await commands.command("record", {on: false});
    return JSON.stringify(result).includes("film.mp4") ? "film/film.mp4" : "film/film.png";
  }],
  recording: ["Recording", "The actions so far, as a session file that replays to the same state", async () => (await connection.ask("recording")).file],
};

for (const [name, [label, title, make]] of Object.entries(kFiles)) {
  const button = element("button", {type: "button", title, "data-file": name}, label);
  button.addEventListener("click", async () => {
    try {
      const file = await make();
      if (file) download(file);
    } catch (error) {
      banner(error.message);
    }
  });
  by_id("files").append(button);
}

by_id("scene").addEventListener("change", () => commands.tried("load", {scene: by_id("scene").value}));
by_id("run").addEventListener("click", () => commands.tried(frame?.running ? "pause" : "start"));
by_id("step").addEventListener("click", () => commands.tried("run", {steps: 1}));
by_id("reset").addEventListener("click", () => commands.tried("reset"));
by_id("undo").addEventListener("click", () => commands.tried("undo"));
// A field that is being typed in takes its own letters back.
addEventListener("keydown", (event) => {
  if (event.key !== "z" || !(event.ctrlKey || event.metaKey) || event.shiftKey || by_id("undo").disabled) return;
  if (event.target.matches("input[type=number], input[type=text], textarea")) return;
  event.preventDefault();
  commands.tried("undo");
});
by_id("pace").addEventListener("change", () => {
  const pace = by_id("pace");
  if (pace.value !== "" && pace.validity.valid) return commands.tried("pace", {steps_per_frame: number_in(pace)});
  banner(`The steps per picture are a whole number from ${pace.min} to ${pace.max}.`);
  pace.value = state?.steps_per_frame ?? 1;
});

const shaders = await fetch("shaders.json").then((answer) => answer.json());
const plots = new Plots(by_id("plots"));
const timeline = new Timeline(by_id("timeline"), commands);
let picture = null;
const connection = new Connection(heard, changed);
show_actions(by_id("actions"), commands);
picture = new Picture(connection, shaders, commands);
// For those who look into the page, tests among them.
window.quicksand = {connection, picture, plots, timeline, state: () => state, frame: () => frame};

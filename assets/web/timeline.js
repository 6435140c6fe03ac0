// Walking through a run: its controls, and a strip with its phases as coloured spans and the rate at which bonds fail.
import {element, short} from "./numbers.js";

// Of the phases, as the curves of the program's plots.
const kColours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
const kBand = 16;  // of the names [px]

// Runs of samples of one phase: [first, end).
export function spans_of(phases) {
  const spans = [];
  phases.forEach((phase, k) => {
    if (spans.at(-1)?.phase !== phase) spans.push({first: k, end: k, phase});
    spans.at(-1).end = k + 1;
  });
  return spans;
}

export class Timeline {
  // `commands.tried(name, values)` performs one.
  constructor(part, commands) {
    Object.assign(this, {part, commands, run: null, now: null, wanted: null});
    const button = (text, title, press) => {
      const made = element("button", {type: "button", title}, text);
      made.addEventListener("click", press);
      return made;
    };
    this.strip = element("canvas", {"aria-hidden": "true"});
    // Over time, as the strip is; by keys it goes from sample to sample.
    this.slider = element("input", {type: "range", min: 0, max: 0, step: "any", value: 0, "aria-label": "Time", title: "Arrow keys move by one sample, Home and End to the ends"});
    this.play = button("Play", "Plays or pauses; also by the space bar on the picture", () => this.play_or_pause());
    this.speed = element("input", {type: "number", min: 0.01, max: 1000, step: "any", "aria-label": "Speed, samples per picture", title: "Samples between two pictures"});
    this.loop = element("input", {type: "checkbox"});
    this.phase = element("select", {"aria-label": "Phase", title: "Shows the first sample of a phase"});
    this.place = element("output", {});
    this.go_on = button("Go on from here", "Continues computing from the nearest checkpoint: the run's state, or its beginning",
                        () => commands.tried("go_on"));
    part.append(this.strip, this.slider, element("div", {className: "controls"},
      button("Back", "One sample back", () => this.step(-1)), this.play, button("Forward", "One sample forward", () => this.step(1)),
      element("label", {}, "Speed", this.speed), element("label", {}, this.loop, "Loop"), element("label", {}, "Phase", this.phase),
      this.place, this.go_on));
    this.slider.addEventListener("input", () => this.show_nearest(Number(this.slider.value)));
    this.slider.addEventListener("keydown", (e) => this.press(e));
    this.speed.addEventListener("change", () => this.speed.validity.valid && this.speed.value &&
      commands.tried("play", {on: this.now.playing, speed: Number(this.speed.value)}));
    this.loop.addEventListener("change", () => commands.tried("play", {on: this.now.playing, loop: this.loop.checked}));
    this.phase.addEventListener("change", () => commands.tried("show", {phase: Number(this.phase.value)}));
    this.strip.addEventListener("pointerdown", (e) => (this.strip.setPointerCapture(e.pointerId), this.point(e)));
    this.strip.addEventListener("pointermove", (e) => e.buttons & 1 && this.point(e));
    new ResizeObserver(() => this.draw()).observe(part);
  }

  play_or_pause() { this.commands.tried("play", {on: !this.now?.playing}); }
  step(by) { this.commands.tried("show", {by}); }

  // Of samples that come faster than they are shown, the last.
  async show(sample) {
    this.wanted = sample;
    if (this.showing) return;
    this.showing = true;
    while (this.wanted !== null) {
      const next = this.wanted;
      this.wanted = null;
      await this.commands.tried("show", {sample: next});
    }
    this.showing = false;
  }

  press(event) {
    const ends = this.now.samples - 1, from = this.wanted ?? this.now.sample;
    const to = {ArrowLeft: from - 1, ArrowDown: from - 1, ArrowRight: from + 1, ArrowUp: from + 1, Home: 0, End: ends}[event.key];
    if (to === undefined) return;
    event.preventDefault();
    this.show(Math.min(ends, Math.max(0, to)));
  }

  point(event) {
    if (!this.run) return;
    const {sample_times: times} = this.run, share = Math.min(1, Math.max(0, event.offsetX / this.strip.clientWidth));
    this.show_nearest(times[0] + share * (times.at(-1) - times[0]));
  }

  show_nearest(time) {
    if (!this.run) return;
    const {sample_times: times} = this.run;
    let best = 0;
    times.forEach((t, k) => { if (Math.abs(t - time) <= Math.abs(times[best] - time)) best = k; });
    this.show(best);
  }

  // The moments of the run: sample_times, failure_rates, sample_phases, phase_names.
  set_run(run) {
    this.run = run.sample_times?.length ? run : null;
    if (!this.run) return;
    const spans = spans_of(this.run.sample_phases), names = JSON.stringify(spans.map((s) => s.phase));
    if (this.phase.dataset.made !== names) {
      this.phase.dataset.made = names;
      const once = spans.filter((s, i) => spans.findIndex((other) => other.phase === s.phase) === i);
      this.phase.replaceChildren(...once.map(({phase}) => element("option", {value: phase}, `${phase} ${run.phase_names[phase]}`)));
      this.phase.value = this.shown_phase;
    }
    if (this.now) this.place_slider();
    this.draw();
  }

  // The shown moment of a frame; null where the session computes.
  set_moment(frame) {
    const now = frame.timeline ?? null;
    this.now = now;
    this.part.hidden = !now;
    if (!now) return;
    this.time = frame.time;
    this.shown_phase = frame.phase;
    this.place_slider();
    this.slider.setAttribute("aria-valuetext", `time ${short(frame.time)}, phase ${frame.phase_name}`);
    this.play.textContent = now.playing ? "Pause" : "Play";
    this.play.classList.toggle("first", !now.playing);
    if (document.activeElement !== this.speed) this.speed.value = now.speed;
    this.loop.checked = now.loop;
    if (document.activeElement !== this.phase) this.phase.value = frame.phase;
    this.place.textContent = `sample ${now.sample + 1} of ${now.samples}`;
    this.draw();
  }

  // What is being dragged stays where it is.
  place_slider() {
    const {run, time} = this, times = run?.sample_times ?? [time];
    Object.assign(this.slider, {min: times[0], max: Math.max(time, times.at(-1))});
    if (!this.showing) this.slider.value = time;
  }

  draw() {
    const {strip, run, now} = this;
    if (!run || !now || !strip.clientWidth) return;
    const ratio = window.devicePixelRatio || 1, [w, h] = [strip.clientWidth, strip.clientHeight];
    [strip.width, strip.height] = [Math.round(w * ratio), Math.round(h * ratio)];
    const g = strip.getContext("2d"), style = getComputedStyle(document.documentElement);
    const [ink, faint, curve, accent] = ["ink", "faint", "curve", "accent"].map((n) => style.getPropertyValue("--" + n));
    const {sample_times: times, failure_rates: rates} = run, first = times[0], lasts = Math.max(times.at(-1) - first, 1e-9);
    const x_of = (k) => ((times[k] - first) / lasts) * w;
    g.scale(ratio, ratio);
    g.font = "12px Roboto, sans-serif";
    for (const span of spans_of(run.sample_phases)) {
      const from = span.first ? x_of(span.first - 1) : 0, to = x_of(span.end - 1), name = run.phase_names[span.phase];
      g.fillStyle = kColours[span.phase % kColours.length];
      g.globalAlpha = 0.55;
      g.fillRect(from, 0, to - from, kBand);
      g.globalAlpha = 0.1;
      g.fillRect(from, kBand, to - from, h - kBand);
      g.globalAlpha = 1;
      g.fillStyle = ink;
      if (g.measureText(name).width + 8 < to - from) g.fillText(name, from + 4, kBand - 4);
    }
    let most = 0;
    for (const rate of rates) most = Math.max(most, rate);
    g.fillStyle = curve;
    for (let k = 1; most > 0 && k < rates.length; ++k) {
      const height = rates[k] > 0 ? Math.max(1, ((h - kBand - 4) * rates[k]) / most) : 0;
      g.fillRect(x_of(k - 1), h - height, Math.max(1, x_of(k) - x_of(k - 1)), height);
    }
    g.fillStyle = faint;
    g.textAlign = "right";
    if (most > 0) g.fillText(`up to ${short(most)} bonds fail per √(d/g)`, w - 4, kBand + 13);
    g.fillStyle = accent;
    g.fillRect(Math.round(x_of(Math.min(now.sample, times.length - 1))) - 1, 0, 2, h);
  }
}

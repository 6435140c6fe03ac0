// Controls made from the descriptions that the server sends: each sends a command when it is changed, and shows why a
// value was refused.
import {capitalised, element, sentence, short, typeset, unit_text} from "./numbers.js";

function help_of(field) {
  let help = field.help ? sentence(field.help) : capitalised(field.label);
  if (field.low !== undefined) {
    const unit = unit_text(field.unit);
    help += `. From ${field.above_low ? "above " : ""}${short(field.low)} to ${short(field.high)}${unit ? " " + unit : ""}`;
  }
  return help + (field.value === null ? ". This scene does not model it." : ".");
}

function input_of(field) {
  if (field.kind === "word") {
    const select = element("select", {}, ...field.words.map((w) => element("option", {value: w}, capitalised(w))));
    select.value = field.value ?? "";
    return select;
  }
  if (field.kind === "flag") return element("input", {type: "checkbox", checked: Boolean(field.value)});
  const number = element("input", {type: "number", step: field.kind === "integer" ? "1" : "any", min: field.low, max: field.high});
  number.value = field.value ?? "";
  number.placeholder = "none";
  return number;
}

// What stands in a field of numbers. Throws where that is none; an empty field says what `empty` says, if anything.
export function number_in(input, empty) {
  if (input.validity.badInput || (input.value === "" && empty === undefined)) throw new Error("takes a number");
  return input.value === "" ? empty : Number(input.value);
}

function value_of(field, input) {
  if (field.kind === "flag") return input.checked;
  if (field.kind === "word") return input.value;
  return number_in(input, field.empty);
}

const problem_of = (input) => input.closest("label").querySelector(".problem");

function refuse(input, reason) {
  input.classList.add("refused");
  problem_of(input).textContent = reason;
  problem_of(input).hidden = false;
}

function accept(input) {
  input.classList.remove("refused");
  problem_of(input).hidden = true;
}

// `change(value)` gives a promise that fails with the reason of a refusal.
function control(field, change) {
  const input = input_of(field), unit = unit_text(field.unit), help = help_of(field);
  input.dataset.path = field.path;
  input.title = help;
  const problem = element("span", {className: "problem", role: "alert", hidden: true});
  input.addEventListener("change", async () => {
    try {
      await change(value_of(field, input));
      accept(input);
    } catch (error) {
      refuse(input, error.message);
    }
  });
  input.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    input.value = field.value ?? "";
    accept(input);
    input.blur();
  });
  if (field.kind === "flag") return element("label", {title: help}, input, capitalised(field.label), problem);
  const side = element("span", {className: "with_unit"}, input, unit ? element("small", {title: field.unit}, ...typeset(unit)) : null);
  return element("label", {className: "row", title: help}, element("span", {}, capitalised(field.label)), side, problem);
}

// Fills a part of the page anew, unless somebody is typing in it; the focus stays where it was, and what was refused too.
function fill(part, text, make) {
  if (part.dataset.made === text || part.contains(document.activeElement?.closest("input[type=number]"))) return;
  const focus = part.contains(document.activeElement) ? document.activeElement.dataset.path : null;
  const refused = [...part.querySelectorAll("input.refused")];
  part.dataset.made = text;
  part.replaceChildren(...make());
  for (const old of refused) {
    const input = part.querySelector(`[data-path="${old.dataset.path}"]`);
    if (!input || input.disabled) continue;
    input.value = old.value;
    refuse(input, problem_of(old).textContent);
  }
  if (focus) part.querySelector(`[data-path="${focus}"]`)?.focus();
}

export function show_parameters(part, state, commands) {
  fill(part, JSON.stringify(state.parameters), () =>
    state.parameters.flatMap((group) => [
      element("h3", {}, group.name),
      ...group.parameters.map((field) => {
        const made = control(field, (value) => commands.command("set", {path: field.path, value}));
        if (field.value === null) made.querySelector("input, select").disabled = true;
        return made;
      }),
    ]));
}

export function show_view(part, state, commands) {
  fill(part, JSON.stringify(state.view) + state.follow, () => {
    const change = (field) => (value) => commands.command("view", {[field.path]: value});
    const rows = (kinds) => state.view.filter((f) => kinds.includes(f.kind)).map((f) => control({...f, empty: null}, change(f)));
    const follow = control({path: "follow", label: "Follow intruder", help: "keeps the intruder in the middle", kind: "flag", value: state.follow},
                           (on) => commands.command("camera", {follow: on ? "intruder" : "none"}));
    return [...rows(["word"]), element("div", {className: "flags"}, ...rows(["flag"]), follow), ...rows(["number"])];
  });
}

// What can be done to the packing by hand: a button with its force beside it.
export function show_actions(part, commands) {
  const longest = 20;
  const acts = [
    ["Push", "Puts an intruder on the surface and pushes it down", 1e4, (force) => ["push", {diameter: 3, density: 0.5, force, max_time: longest}]],
    ["Pull out", "Finds the smallest force that pulls the intruder out", 10, (first_force) => ["pull", {first_force}]],
    ["Piston", "Places a piston on the packing and presses it down", 1e3, (force) => ["piston", {mass: 1, force, max_time: longest}]],
    ["Heal", "Restores the bonds of all contacts", null, () => ["heal", {}]],
  ];
  for (const [name, help, force, command] of acts) {
    const input = force === null ? null : element("input", {type: "number", min: "0", step: "any", value: force, "aria-label": `Force of ${name.toLowerCase()} in grain weights`});
    const button = element("button", {type: "button", title: help}, name);
    button.addEventListener("click", () => {
      try {
        commands.tried(...command(input ? number_in(input) : 0));
      } catch (error) {
        commands.refused(`The force of ${name.toLowerCase()} ${error.message}.`);
      }
    });
    part.append(element("div", {className: "row"}, button, input ? element("span", {className: "with_unit"}, input, element("small", {}, ...typeset("F_g"))) : ""));
  }
}

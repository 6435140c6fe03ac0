// What holds a grain: beside the mouse in short, in the panel in full.
import {element, grouped, short, typeset} from "./numbers.js";

function readings(body) {
  const pair = ([x, y]) => `(${short(x)}, ${short(y)})`;
  const list = [
    [body.role === "intruder" ? "Intruder" : "Grain", grouped(body.body)],
    ["Diameter [d]", short(body.diameter)],
    ["Position [d]", pair(body.position)],
    ["Velocity [√(g d)]", pair(body.velocity)],
    ["Spin [√(g/d)]", short(body.spin)],
    ["Active bonds", body.active_bonds],
  ];
  if (body.applied[0] !== 0 || body.applied[1] !== 0) list.splice(5, 0, ["Applied force [F_g]", pair(body.applied)]);
  return list;
}

function rows_of(list) {
  return element("dl", {}, ...list.flatMap(([name, value]) => [element("dt", {}, ...typeset(name)), element("dd", {}, String(value))]));
}

function contacts(body) {
  const cell = (kind) => (text) => element(kind, {}, text);
  const rows = body.contacts.map((c) => [c.with, short(c.normal), short(c.tangential), c.bond]);
  return element("table", {}, element("thead", {}, element("tr", {}, ...["with", "normal", "tangential", "bond"].map(cell("th")))),
                 element("tbody", {}, ...rows.map((row) => element("tr", {}, ...row.map(cell("td"))))));
}

export function show_tooltip(tooltip, body) {
  const list = readings(body);
  tooltip.replaceChildren(rows_of([list[0], list[3], list.at(-1)]), body.contacts.length ? contacts(body) : "");
}

export function show_inspection(part, body) {
  part.replaceChildren(rows_of(readings(body)), body.contacts.length ? contacts(body) : element("p", {}, "It touches nothing."),
                       element("p", {className: "faint"}, "Forces of the last step, in weights of a grain; those that press are positive."));
}

#include "app/serve/page_state.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "app/base/assets.h"
#include "app/serve/binary_message.h"
#include "app/session/disk_at.h"
#include "app/session/failure_rates.h"
#include "app/session/parameters.h"
#include "app/view/view_fields.h"

namespace quicksand {

namespace {

Json parameter_json(const Parameter& p) {
  constexpr const char* kKinds[] = {"number", "integer", "flag", "word"};
  Json json{{"path", p.path},
            {"label", p.label},
            {"help", p.help},
            {"unit", p.unit},
            {"kind", kKinds[static_cast<std::size_t>(p.kind)]},
            {"value", p.value}};
  if (p.kind == Parameter::Kind::number || p.kind == Parameter::Kind::integer) {
    json["low"] = p.low;
    json["high"] = p.high;
    json["above_low"] = p.above_low;
  }
  if (p.kind == Parameter::Kind::word) json["words"] = p.words;
  return json;
}

Json parameters_json(const Scenario& scenario) {
  Json groups = Json::array();
  for (const ParameterGroup& group : parameters_of(scenario)) {
    Json parameters = Json::array();
    for (const Parameter& p : group.parameters) parameters.push_back(parameter_json(p));
    groups.push_back({{"name", group.name}, {"parameters", std::move(parameters)}});
  }
  return groups;
}

Json field_json(const ViewField& field, const char* kind) {
  return {{"path", field.name}, {"label", field.label}, {"help", field.help}, {"kind", kind}};
}

Json view_json(const View& view) {
  Json fields = Json::array();
  for (const ViewWord& word : view_words()) {
    Json json = field_json(word.field, "word");
    json["words"] = word.words;
    json["value"] = word.word(view);
    fields.push_back(std::move(json));
  }
  for (const ViewFlag& flag : view_flags()) {
    if (flag.field.label == nullptr) continue;
    Json json = field_json(flag.field, "flag");
    json["value"] = view.*flag.value;
    fields.push_back(std::move(json));
  }
  for (const ViewNumber& number : view_numbers()) {
    if (!number.matters(view)) continue;
    Json json = field_json(number.field, "number");
    json["low"] = number.limits.low;
    json["high"] = number.limits.high;
    json["unit"] = number.limits.unit;
    json["value"] = view.*number.value;
    fields.push_back(std::move(json));
  }
  return fields;
}

Json contacts_json(const World& world, int body) {
  Json contacts = Json::array();
  const double dt = world.impulse_dt;
  for (const Contact& contact : world.contacts) {
    const auto [a, b] = world.rows(contact.pair);
    if (a != body && b != body) continue;
    const Bond* bond = world.bonds.find(contact.pair);
    contacts.push_back({{"with", body_name(world, a == body ? b : a)},
                        {"normal", dt > 0 ? Json(contact.normal_force(dt)) : Json()},
                        {"tangential", dt > 0 ? Json(contact.impulse.y() / dt) : Json()},
                        {"bond", bond == nullptr                    ? "none"
                                 : bond->state == BondState::active ? "active"
                                                                    : "broken"}});
  }
  return contacts;
}

// What the timeline shows of each sample; the names of its phases, by their numbers.
Json add_moments(BinaryMessage& message, const std::vector<Moment>& moments) {
  std::vector<float> times, rates;
  std::vector<std::int32_t> phases;
  Json names = Json::object();
  times.reserve(moments.size());
  phases.reserve(moments.size());
  for (const Moment& moment : moments) {
    times.push_back(static_cast<float>(moment.time));
    phases.push_back(moment.phase);
    names[std::to_string(moment.phase)] = moment.phase_name;
  }
  rates.reserve(moments.size());
  for (const double rate : failure_rates(moments)) rates.push_back(static_cast<float>(rate));
  message.add("sample_times", std::span<const float>(times));
  message.add("failure_rates", std::span<const float>(rates));
  message.add("sample_phases", std::span<const std::int32_t>(phases));
  return names;
}

}  // namespace

Json page_state(const Session& session) {
  Json scenes = Json::array();
  for (const auto& path : shipped_scenes()) scenes.push_back(path.stem().string());
  Json state{{"kind", "state"}, {"scenes", std::move(scenes)}, {"loaded", session.loaded()}};
  if (!session.loaded()) return state;
  const Scenario& scenario = session.scenario();
  state["scene"] = scenario.name;
  state["description"] = scenario.description;
  state["parameters"] = parameters_json(scenario);
  state["view"] = view_json(session.view);
  Json phases = Json::array();
  for (const Phase& phase : session.phases()) phases.push_back(phase_name(phase));
  state["phases"] = std::move(phases);
  state["last_change"] = session.last_change();
  state["steps_per_frame"] = session.steps_per_frame;
  state["walks"] = session.timeline() != nullptr;
  state["follow"] = session.view.follow;
  return state;
}

std::string plots_message(const Session& session) {
  BinaryMessage message;
  Json columns = Json::array();
  const std::vector<Values>& history = session.history();
  std::vector<float> values(history.size());
  for (std::size_t q = 0; q < quantities().size(); ++q) {
    bool numbers = false;
    std::ranges::transform(history, values.begin(), [&](const Values& row) {
      const std::optional<double> number = number_in(row[q]);
      numbers = numbers || number;
      return number ? static_cast<float>(*number) : std::numeric_limits<float>::quiet_NaN();
    });
    if (!numbers) continue;
    const Quantity& quantity = quantities()[q];
    const std::string name(quantity.name);
    columns.push_back({{"name", name}, {"unit", quantity.unit}, {"help", quantity.help}});
    message.add(name.c_str(), std::span<const float>(values));
  }
  Json head{{"kind", "plots"}, {"columns", std::move(columns)}};
  if (const Timeline* timeline = session.timeline()) {
    head["phase_names"] = add_moments(message, timeline->moments());
  }
  return message.finish(std::move(head));
}

Json body_state(const Session& session, int body) {
  const World& world = session.world();
  const Disks& disks = world.disks;
  const auto k = static_cast<std::size_t>(body);
  const auto active = std::ranges::count_if(world.bonds.list, [&](const Bond& bond) {
    const auto [a, b] = world.rows(bond.pair);
    return bond.state == BondState::active && (a == body || b == body);
  });
  return {{"body", body},
          {"role", disks.role[k] == DiskRole::intruder ? "intruder" : "grain"},
          {"diameter", 2 * disks.radius[k]},
          {"position", {world.wrapped_x(disks.position[k].x()), disks.position[k].y()}},
          {"velocity", {disks.velocity[k].x(), disks.velocity[k].y()}},
          {"spin", disks.velocity[k].z()},
          {"applied", {disks.applied[k].x(), disks.applied[k].y()}},
          {"active_bonds", active},
          {"contacts", contacts_json(world, body)}};
}

}  // namespace quicksand
